"""Decisions on ROS: distribution, rosdep keys, workspace, sister repositories."""
