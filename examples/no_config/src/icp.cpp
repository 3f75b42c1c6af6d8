// SPDX-License-Identifier: Apache-2.0
#include "icp/icp.hpp"

#include <Eigen/SVD>

namespace icp
{

Eigen::Isometry3d align_pairs(const Cloud& source, const Cloud& target)
{
  const Eigen::Vector3d source_mean = source.rowwise().mean();
  const Eigen::Vector3d target_mean = target.rowwise().mean();
  const Eigen::Matrix3d covariance = (target.colwise() - target_mean) * (source.colwise() - source_mean).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d product = svd.matrixU() * svd.matrixV().transpose();
  // A reflection fits as well as a rotation; the sign of the weakest direction rules it out
  const Eigen::Vector3d signs(1.0, 1.0, product.determinant() < 0.0 ? -1.0 : 1.0);

  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  result.translation() = target_mean - result.linear() * source_mean;
  return result;
}

Eigen::Isometry3d align(const Cloud& source, const Cloud& target, int iterations)
{
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const Cloud moved = (result.linear() * source).colwise() + result.translation();
    Cloud nearest(3, moved.cols());
    for (Eigen::Index i = 0; i < moved.cols(); ++i) {
      Eigen::Index best;
      (target.colwise() - moved.col(i)).colwise().squaredNorm().minCoeff(&best);
      nearest.col(i) = target.col(best);
    }
    result = align_pairs(source, nearest);
  }
  return result;
}

}  // namespace icp
