"""Commands for a second terminal."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]

FIRST = "Run the launch file of the desired scenario.\n"
THEN = "Then, in other terminal, run a tester:\n"
RUN = "rosrun demo drive.py\n"


@pytest.mark.parametrize(
    ("page", "first"),
    [
        (f"{FIRST}\n{THEN}{RUN}", False),
        (f"{FIRST}\n{THEN}\n```\n{RUN}```\n", False),
        (f"{FIRST}```\nroslaunch other world.launch\n```\n{THEN}```\n{RUN}```\n", True),
        (f"Start the core:\n\n    roscore\n\nIn another terminal:\n```\n{RUN}```\n", True),
        (f"Start `roscore`. {THEN}```\n{RUN}```\n", True),
        (f"{FIRST}\n## Driving\n\nOpen a new terminal:\n```\n{RUN}```\n", True),
        (f"Open a second terminal and source the workspace.\n\n{RUN}", True),
        (f"{FIRST}\n{RUN}", True),
    ],
)
def test_it_needs_what_the_page_only_says_in_words(tree: Tree, page: str, first: bool) -> None:
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        "README.md": f"# Demo\nFor ROS Noetic.\n\n## Usage\n\n{page}",
        "scripts/drive.py": "#!/usr/bin/env python3\nimport rospy\nif __name__ == '__main__':\n    rospy.spin()\n",
        **{f"launch/{name}.launch": "<launch><node pkg='demo' type='drive.py' name='a'/></launch>\n" for name in "ab"},
    }
    assert (tree(files).command == ("rosrun", "demo", "drive.py")) is first


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("Run the launch sim_(scenario_name)_nav.launch.", ("roslaunch", "demo", "sim_hall_nav.launch")),
        ("Launch sim_<scenario>_nav.launch first.", ("roslaunch", "demo", "sim_hall_nav.launch")),
        ("Start b.launch.", ("roslaunch", "demo", "b.launch")),
        ("Run the launch (name).launch.", ("bash",)),
        ("Run the launch sim_(name)_slam.launch.", ("bash",)),
    ],
)
def test_what_runs_in_the_first_is_the_default(tree: Tree, said: str, command: tuple[str, ...]) -> None:
    launch = "<launch><node pkg='demo' type='drive.py' name='a'/></launch>\n"
    names = ("a", "b", "sim_hall_nav", "sim_lab_nav")
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        "README.md": f"# Demo\nFor ROS Noetic.\n\n## Usage\n\n{said}\n\n{THEN}{RUN}",
        "scripts/drive.py": "#!/usr/bin/env python3\nimport rospy\nif __name__ == '__main__':\n    rospy.spin()\n",
        **{f"launch/{name}.launch": launch for name in names},
    }
    assert tree(files).command == command
