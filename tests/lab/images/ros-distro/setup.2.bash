# Environment of a ROS 2 installation, as the real setup.bash leaves it; Debian's ament itself lies below /usr.
export ROS_VERSION=2
export ROS_PYTHON_VERSION=3
export AMENT_PREFIX_PATH=/opt/ros/$ROS_DISTRO
export CMAKE_PREFIX_PATH=/opt/ros/$ROS_DISTRO
export LD_LIBRARY_PATH=/opt/ros/$ROS_DISTRO/lib
export PYTHONPATH=/opt/ros/$ROS_DISTRO/lib/python3/dist-packages
case ":$PATH:" in *":/opt/ros/$ROS_DISTRO/bin:"*) ;; *) export PATH=/opt/ros/$ROS_DISTRO/bin:$PATH ;; esac
