#include <cstdio>

#include <ros/ros.h>
#include <std_msgs/Float64.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "drift");
  const double commanded[] = {0.5, 0.5, 0.4, 0.2}, driven[] = {0.48, 0.51, 0.37, 0.2};
  std_msgs::Float64 drift;
  for (int step = 0; step < 4; ++step)
    drift.data += commanded[step] - driven[step];
  std::printf("drift after 4 steps: %.2f m\n", drift.data);
  return 0;
}
