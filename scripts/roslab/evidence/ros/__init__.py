"""Readers of files that only ROS repositories have."""
