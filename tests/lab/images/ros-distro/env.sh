#!/bin/bash
# Run a command in the environment of this ROS installation, as the real env.sh does; catkin_tools asks for it.
# shellcheck source=setup.1.bash
source "$(dirname "${BASH_SOURCE[0]}")/setup.bash"
exec "$@"
