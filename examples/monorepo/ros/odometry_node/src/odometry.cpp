// SPDX-License-Identifier: Apache-2.0
// Subscribes to wheel ticks and publishes the pose they add up to.
#include <cmath>

#include <geometry_msgs/Pose2D.h>
#include <odometry_msgs/WheelTicks.h>
#include <ros/ros.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "odometry");
  ros::NodeHandle node;
  ros::NodeHandle settings("~");
  const double metres_per_tick = settings.param("metres_per_tick", 0.001);
  const double wheel_distance = settings.param("wheel_distance", 0.3);

  geometry_msgs::Pose2D pose;
  ros::Publisher poses = node.advertise<geometry_msgs::Pose2D>("pose", 10, true);
  poses.publish(pose);
  boost::function<void(const odometry_msgs::WheelTicks::ConstPtr&)> add = [&](const odometry_msgs::WheelTicks::ConstPtr& ticks) {
    const double left = metres_per_tick * ticks->left;
    const double right = metres_per_tick * ticks->right;
    const double turn = (right - left) / wheel_distance;
    pose.x += 0.5 * (left + right) * std::cos(pose.theta + 0.5 * turn);
    pose.y += 0.5 * (left + right) * std::sin(pose.theta + 0.5 * turn);
    pose.theta += turn;
    poses.publish(pose);
  };
  ros::Subscriber ticks = node.subscribe<odometry_msgs::WheelTicks>("ticks", 100, add);
  ros::spin();
  return 0;
}
