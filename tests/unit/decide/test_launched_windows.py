"""The windows of nodes in Python that the default command starts by their package and name."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
NODE = "import rclpy\n{}\ndef main():\n    rclpy.init()\nif __name__ == '__main__':\n    main()\n"
VIEWER = "import mujoco.viewer\ndef show(model, data):\n    return mujoco.viewer.launch_passive(model, data)"
PACKAGE = (
    "<package><name>{}</name><depend>rclpy</depend><export><build_type>ament_python</build_type></export></package>"
)
SETUP = "from setuptools import setup\nsetup(name='{0}', entry_points={{'console_scripts': ['sim = {0}.sim:main']}})\n"
LAUNCH = "from launch_ros.actions import Node\ndef generate_launch_description():\n    return LaunchDescription([{}])\n"
FILES = {
    "arm/package.xml": PACKAGE.format("arm"),
    "arm/setup.py": SETUP.format("arm"),
    "arm/arm/sim.py": NODE.format(VIEWER),
    "arm/arm/drive.py": NODE.format(""),
    "up/package.xml": PACKAGE.format("up"),
    "up/setup.py": SETUP.format("up"),
    "up/launch/sim.launch.py": LAUNCH.format("Node(package='arm', name='a', executable='sim')"),
    "up/launch/turned.launch.py": LAUNCH.format("Node(executable='sim', package='arm')"),
    "up/launch/drive.launch.py": LAUNCH.format("Node(package='arm', executable='drive')"),
    "up/launch/all.launch.py": LAUNCH.format(
        "IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(here, 'sim.launch.py')))"
    ),
    "down/launch/all.launch.py": LAUNCH.format(
        "IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(here, 'sim.launch.py')))"
    ),
    "down/package.xml": PACKAGE.format("down"),
    "down/setup.py": SETUP.format("down"),
    "down/launch/sim.launch.py": LAUNCH.format("Node(package='arm', executable='drive')"),
    "requirements.txt": "mujoco==3.2.0\n",
}


@pytest.mark.parametrize(
    ("command", "gui"),
    [
        ("ros2 launch up sim.launch.py", True),
        ("ros2 launch up turned.launch.py", True),
        ("ros2 launch up all.launch.py", True),
        ("ros2 launch up drive.launch.py", False),
        ("ros2 launch down all.launch.py", False),
        ("ros2 run arm sim", True),
        ("ros2 run arm drive", False),
    ],
)
def test_a_node_opens_a_window(tree: Tree, command: str, *, gui: bool) -> None:
    decision = tree({**FILES, "README.md": f"```\n{command}\n```\n"})
    assert " ".join(decision.command) == command
    assert decision.gui is gui
    assert decision.variables == (() if gui else (("MUJOCO_GL", "egl"),))


XML = '<launch><arg name="rviz" default="{}"/><node pkg="rviz" type="rviz" name="r" {}="$(arg rviz)"/></launch>'
CALLS = (
    "LaunchDescription([DeclareLaunchArgument('rviz', default_value='{}'), "
    "Node(package='rviz2', executable='rviz2', condition={}Condition(LaunchConfiguration('rviz')))])"
)


@pytest.mark.parametrize(
    ("default", "condition", "given", "shown"),
    [
        ("false", "if", " rviz:=true", True),
        ("false", "if", " rviz:=false", False),
        ("false", "if", " other:=true", False),
        ("false", "if", "", False),
        ("true", "unless", " rviz:=false", True),
    ],
)
@pytest.mark.parametrize("python", [False, True])
def test_a_command_that_switches_a_viewer_on(
    tree: Tree, default: str, condition: str, given: str, *, shown: bool, python: bool
) -> None:
    name, start = ("a.launch.py", "ros2 launch") if python else ("a.launch", "roslaunch")
    text = CALLS.format(default, condition.title()) if python else XML.format(default, condition)
    tool = "ament_cmake" if python else "catkin"
    decision = tree(
        {
            "package.xml": f"<package><name>demo</name><buildtool_depend>{tool}</buildtool_depend></package>",
            "CMakeLists.txt": f"project(demo)\nfind_package({tool} REQUIRED)\ninstall(DIRECTORY launch)\n",
            "README.md": f"# Demo\n## Run\n```\n{start} demo {name}{given}\n```\n",
            f"launch/{name}": text,
        }
    )
    assert decision.gui is shown
    assert decision.command[-1] == (given.strip() or name)
