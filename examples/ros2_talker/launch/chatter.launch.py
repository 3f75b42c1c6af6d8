# SPDX-License-Identifier: Apache-2.0
"""Start the talker and the listener; end when the listener has heard enough."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, EmitEvent, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.events import Shutdown
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    messages = ParameterValue(LaunchConfiguration("messages"), value_type=int)
    listener = Node(
        package="ros2_talker", executable="listener", output="screen", parameters=[{"messages": messages}]
    )
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "messages", default_value="10", description="The listener ends after so many; 0: never"
            ),
            Node(package="ros2_talker", executable="talker"),
            listener,
            RegisterEventHandler(OnProcessExit(target_action=listener, on_exit=[EmitEvent(event=Shutdown())])),
        ]
    )
