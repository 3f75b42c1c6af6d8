#include <ros/ros.h>
#include <lib.h>
int main(int argc, char **argv) {
  ros::Time::init();
  ROS_INFO("the answer is %d", answer());
}
