// SPDX-License-Identifier: Apache-2.0
// Prints what the talker says; with ~messages set, ends after so many.
#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "listener");
  ros::NodeHandle node;
  int wanted = 0;
  ros::NodeHandle("~").param("messages", wanted, 0);  // 0: listen for ever

  int heard = 0;
  boost::function<void(const std_msgs::String::ConstPtr&)> print = [&](const std_msgs::String::ConstPtr& message) {
    ROS_INFO("I heard: %s", message->data.c_str());
    if (++heard == wanted) {
      ros::shutdown();
    }
  };
  ros::Subscriber chatter = node.subscribe<std_msgs::String>("chatter", 10, print);
  ros::spin();
  return wanted == 0 || heard >= wanted ? 0 : 1;
}
