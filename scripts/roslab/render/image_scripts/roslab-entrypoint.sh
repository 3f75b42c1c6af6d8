#!/bin/bash
# Makes ROS and the workspace known, then becomes the command.
set -e

source /usr/local/share/roslab/environment.bash
# What rosrun starts waits for a master, which a launch file brings: where this machine is to have it and none answers
if [ "${1:-}" = rosrun ] && [[ "${ROS_MASTER_URI:-}" =~ ^http://(localhost|127\.0\.0\.1):([0-9]+) ]]; then
  port="${BASH_REMATCH[2]}"
  answers() { (: <"/dev/tcp/localhost/${port}") 2>/dev/null; }
  if ! answers; then
    roscore -p "${port}" >/dev/null 2>&1 &
    for _ in {1..50}; do if answers; then break; fi && sleep 0.2; done
  fi
fi
exec "$@"
