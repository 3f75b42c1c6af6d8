# Environment of a ROS 1 installation, as the real setup.bash leaves it; Debian's ROS itself lies below /usr.
export ROS_VERSION=1
export ROS_PYTHON_VERSION=3
export ROS_ETC_DIR=/opt/ros/$ROS_DISTRO/etc/ros
export ROS_ROOT=/opt/ros/$ROS_DISTRO/share/ros
export ROS_MASTER_URI=${ROS_MASTER_URI:-http://localhost:11311}
export ROS_PACKAGE_PATH=/opt/ros/$ROS_DISTRO/share
export CMAKE_PREFIX_PATH=/opt/ros/$ROS_DISTRO
export LD_LIBRARY_PATH=/opt/ros/$ROS_DISTRO/lib
export PKG_CONFIG_PATH=/opt/ros/$ROS_DISTRO/lib/pkgconfig
export PYTHONPATH=/opt/ros/$ROS_DISTRO/lib/python3/dist-packages
case ":$PATH:" in *":/opt/ros/$ROS_DISTRO/bin:"*) ;; *) export PATH=/opt/ros/$ROS_DISTRO/bin:$PATH ;; esac
if [ -n "${BASH_VERSION:-}" ] && [ -r /usr/share/rosbash/rosbash ]; then . /usr/share/rosbash/rosbash; fi
