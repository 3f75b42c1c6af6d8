#include <Eigen/Dense>
#include <geometry_msgs/Point.h>
#include <ros/ros.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "beacon");
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<geometry_msgs::Point>("beacon", 10);
  Eigen::Vector3d place(1.0, 2.0, 0.5);
  geometry_msgs::Point message;
  message.x = place.x();
  message.y = place.y();
  message.z = place.z();
  for (ros::Rate rate(10); ros::ok(); rate.sleep())
    publisher.publish(message);
  return 0;
}
