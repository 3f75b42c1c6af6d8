"""Decisions on ROS: distribution, keys, workspace, sister repositories."""
