"""Pages of packages that run something each: the whole before a part, a simulation before the robot."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.candidate import Candidate
from roslab.decide.decision import Decision
from roslab.decide.first_command import first_of

Tree = Callable[[dict[str, str]], Decision]


def package(name: str, page: str = "", launch: str = "start") -> dict[str, str]:
    depends = "<buildtool_depend>ament_cmake</buildtool_depend>"
    return {
        f"{name}/package.xml": f"<package format='3'><name>{name}</name>{depends}</package>",
        f"{name}/CMakeLists.txt": f"project({name})\nfind_package(ament_cmake REQUIRED)\n"
        "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n",
        f"{name}/launch/{launch}.launch.py": "from launch import LaunchDescription\n",
        **({f"{name}/README.md": f"# {name}\n```\n{page}\n```\n"} if page else {}),
    }


ARM = package("arm", "ros2 launch arm start.launch.py")
WALKER = package("walker", "ros2 launch walker start.launch.py")
SKIP = "ROS 2 Humble\n```\ncolcon build --packages-skip arm\n```\n"
CI = {".github/workflows/ci.yml": "on: push\njobs:\n  b:\n    steps:\n      - run: colcon build --packages-skip arm\n"}


@pytest.mark.parametrize(
    ("more", "command"),
    [
        ({"README.md": "ROS 2 Humble\n"}, ("ros2", "launch", "arm", "start.launch.py")),
        ({"README.md": SKIP}, ("ros2", "launch", "walker", "start.launch.py")),
        ({"README.md": "ROS 2 Humble\n"} | CI, ("ros2", "launch", "walker", "start.launch.py")),
        (
            {"README.md": f"{SKIP}## Run\n```\nros2 launch arm start.launch.py\n```\n"},
            ("ros2", "launch", "arm", "start.launch.py"),
        ),
    ],
)
def test_what_the_author_s_build_skips_is_not_started(
    tree: Tree, more: dict[str, str], command: tuple[str, ...]
) -> None:
    decision = tree(ARM | WALKER | more)
    assert decision.command == command
    assert (decision.left_out == ("arm",)) == ("arm" not in command)


def candidate(argv: str, file: str, heading: str = "Demo", names: tuple[str, ...] = ("walker2",)) -> Candidate:
    return Candidate(argv=tuple(argv.split()), why="", file=file, line=1, strong=True, heading=heading, names=names)


def test_the_page_of_the_package_called_like_the_repository_comes_first() -> None:
    part = candidate("ros2 launch arm start.launch.py", "arm/README.md")
    whole = candidate("ros2 launch walker start.launch.py", "walker/README.md")
    assert first_of([part, whole]) == whole
    assert first_of([part, candidate("ros2 launch leg start.launch.py", "leg/README.md")]) == part


@pytest.mark.parametrize(
    ("robot", "other", "meant"),
    [
        ("ros2 launch arm hardware.launch.py", "ros2 launch leg sim_pd.launch.py", True),
        ("roslaunch arm_bringup arm.launch", "roslaunch arm_demo arm.launch", True),
        ("ros2 launch arm_drivers arm.launch.py", "ros2 launch leg leg.launch.py", False),
        ("ros2 launch arm_bringup sim.launch.py", "ros2 launch leg demo.launch.py", False),
        ("ros2 launch arm simple_hardwareless.launch.py", "ros2 launch leg sim.launch.py", False),
    ],
)
def test_a_simulation_comes_before_the_robot(robot: str, other: str, meant: bool) -> None:
    first, then = candidate(robot, "arm/README.md"), candidate(other, "leg/README.md")
    assert first_of([first, then]) == (then if meant else first)


def test_the_next_step_of_a_section_does_not_come_before_the_first() -> None:
    first = candidate("roslaunch arm bringup.launch", "README.md")
    assert first_of([first, candidate("roslaunch arm demo.launch", "README.md")]) == first
    assert first_of([first, candidate("roslaunch arm sim.launch", "sub/README.md")]) == first


def test_of_two_sections_the_one_without_the_robot() -> None:
    first = candidate("roslaunch arm bringup.launch", "README.md", "Demo / With it")
    then = candidate("roslaunch arm sim.launch", "README.md", "Demo / Without it")
    assert first_of([first, then]) == then


STATE = '<node pkg="robot_state_publisher" type="robot_state_publisher" name="s"/>'
VIEW = f'<param name="a" command="$(find xacro)/xacro a"/>{STATE}<node pkg="rviz" type="rviz" name="r"/>'
WORLD = '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>'


def described(name: str, launch: str, shown: str) -> dict[str, str]:
    manifest = f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
    return {
        f"{name}/package.xml": manifest,
        f"{name}/CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED)\n",
        f"{name}/launch/{launch}.launch": f"<launch>{shown}</launch>",
        f"{name}/README.md": f"# Start\n```\nroslaunch {name} {launch}.launch\n```\n",
    }


CONTROL = {file: text for file, text in described("arm_control", "go", STATE).items() if "README" not in file}


@pytest.mark.parametrize(
    ("shown", "other", "meant"),
    [
        (VIEW, "arm_gazebo", True),
        (f'{VIEW}<include file="$(find arm_description)/launch/up.launch"/>', "arm_gazebo", True),
        ('<include file="$(find urdf_tutorial)/launch/display.launch"/>', "arm_gazebo", True),
        (VIEW, "arm_hardware", False),  # nothing stands in for the robot
        (f'{VIEW}<node pkg="arm_control" type="a" name="a"/>', "arm_gazebo", False),
        (f'{VIEW}<include file="$(find moveit_demo)/launch/a.launch"/>', "arm_gazebo", False),
        (STATE, "arm_gazebo", False),
    ],
)
def test_a_simulation_comes_before_what_shows_the_model_alone(tree: Tree, shown: str, other: str, meant: bool) -> None:
    up = {"arm_description/launch/up.launch": '<launch><param name="b" value="1"/></launch>'}
    files = up | CONTROL | described("arm_description", "view", shown) | described(other, "start", WORLD)
    first = ("roslaunch", "arm_description", "view.launch")
    assert tree(files).command == (("roslaunch", other, "start.launch") if meant else first)


def test_of_two_that_show_models_the_first(tree: Tree) -> None:
    files = CONTROL | described("arm_description", "view", VIEW) | described("leg_demo", "show", VIEW)
    assert tree(files).command == ("roslaunch", "arm_description", "view.launch")


@pytest.mark.parametrize(("executes", "shows"), [("", True), ("ExecuteProcess(cmd=['gzserver', 'a.world']), ", False)])
def test_a_launch_file_that_starts_gazebo_beside_the_model_shows_more(tree: Tree, executes: str, shows: bool) -> None:
    state, rviz = (f"Node(package='{name}', executable='a'), " for name in ("robot_state_publisher", "rviz2"))
    started = {"arm_control": state, "arm_description": executes + state + rviz, "arm_gazebo": state}
    manifest = "<package><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    files: dict[str, str] = {}
    for name, nodes in started.items():
        made = f"find_package(ament_cmake REQUIRED)\ninstall(DIRECTORY launch DESTINATION share/{name})\n"
        files |= {
            f"{name}/package.xml": manifest.format(name),
            f"{name}/CMakeLists.txt": f"project({name})\n{made}",
            f"{name}/launch/up.launch.py": f"LaunchDescription([{nodes}])\n",
            f"{name}/README.md": f"# Start\n```\nros2 launch {name} up.launch.py\n```\n",
        }
    del files["arm_control/README.md"]
    meant = "arm_gazebo" if shows else "arm_description"
    assert tree({**files, "README.md": "For ROS 2 Humble.\n"}).command == ("ros2", "launch", meant, "up.launch.py")
