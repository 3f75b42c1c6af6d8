"""An image that anyone can run for every robotics repository."""

__version__ = "1.0.0"
