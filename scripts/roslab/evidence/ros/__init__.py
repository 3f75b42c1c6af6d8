"""Readers of what only ROS repositories have."""
