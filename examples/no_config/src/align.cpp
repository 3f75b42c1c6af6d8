// SPDX-License-Identifier: Apache-2.0
// Turns a made-up cloud a little, finds the turn again and prints how well.
#include <cstdlib>
#include <iostream>

#include "icp/icp.hpp"

int main()
{
  std::srand(1);
  const icp::Cloud cloud = icp::Cloud::Random(3, 500);
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
  truth.rotate(Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitZ()));
  truth.pretranslate(Eigen::Vector3d(0.02, -0.01, 0.03));
  const icp::Cloud turned = (truth.linear() * cloud).colwise() + truth.translation();

  const Eigen::Isometry3d found = icp::align(cloud, turned, 30);
  const double angle = Eigen::AngleAxisd(found.linear() * truth.linear().transpose()).angle();
  const double distance = (found.translation() - truth.translation()).norm();
  std::cout << "rotation off by " << angle << " rad, translation by " << distance << " m\n";
  return angle < 1e-3 && distance < 1e-3 ? 0 : 1;
}
