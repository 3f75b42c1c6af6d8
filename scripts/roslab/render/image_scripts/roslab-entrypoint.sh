#!/bin/bash
# Makes ROS and the workspace known, then becomes the command.
set -e

source /usr/local/share/roslab/environment.bash
exec "$@"
