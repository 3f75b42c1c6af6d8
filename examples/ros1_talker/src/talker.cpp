// SPDX-License-Identifier: Apache-2.0
// Says hello ten times a second.
#include <string>

#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "talker");
  ros::NodeHandle node;
  ros::Publisher chatter = node.advertise<std_msgs::String>("chatter", 10);

  ros::Rate rate(10);
  for (int count = 0; ros::ok(); ++count) {
    std_msgs::String message;
    message.data = "hello " + std::to_string(count);
    chatter.publish(message);
    ros::spinOnce();
    rate.sleep();
  }
  return 0;
}
