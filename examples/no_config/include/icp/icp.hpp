// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace icp
{

using Cloud = Eigen::Matrix3Xd;

/// Returns the rotation and translation that bring `source` onto `target`, column by column (Kabsch).
Eigen::Isometry3d align_pairs(const Cloud& source, const Cloud& target);

/// The same where nobody knows which points belong together: nearest neighbours, again and again.
Eigen::Isometry3d align(const Cloud& source, const Cloud& target, int iterations);

}  // namespace icp
