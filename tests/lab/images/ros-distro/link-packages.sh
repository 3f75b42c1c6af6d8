#!/bin/sh
# Show the programs of Debian's ROS packages where the real image has them, /opt/ros/DISTRO/lib/PACKAGE; apt runs this
# after every install. The whole of /usr/lib must not show there: its Python modules would hide what pip installed.
for manifest in /usr/share/*/package.xml; do
    name=$(basename "$(dirname "$manifest")")
    if [ -d "/usr/lib/$name" ]; then ln -sfn "/usr/lib/$name" "/opt/ros/$ROS_DISTRO/lib/$name"; fi
done
