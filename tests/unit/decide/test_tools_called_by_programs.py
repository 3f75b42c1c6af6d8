"""A program that starts ROS's tools needs an image with ROS, though it imports nothing of it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MEASURE = (
    "import subprocess\nimport yaml\nout = 'bag'\nplay = f'ros2 bag play {out}'\nsubprocess.run(play, shell=True)\n"
)
OLD = "import os\nimport yaml\nos.system('rosbag play a.bag')\n"


def page(said: str, run: str = "cd src/\npython3 measure.py") -> str:
    return f"# Demo\n\n{said}\n\n## Run\n\n```\n{run}\n```\n"


@pytest.mark.parametrize(
    ("files", "text", "kind"),
    [
        ({"src/measure.py": MEASURE}, page("It uses ROS 2 Galactic."), "ros2"),
        ({"src/measure.py": MEASURE, "requirements.txt": "numpy\n"}, page("It uses ROS 2 Galactic."), "ros2"),
        ({"src/measure.py": MEASURE.replace("f'ros2 bag", "['ros2', 'bag',")}, page("ROS 2 Galactic"), "ros2"),
        ({"src/measure.py": OLD}, page("For ROS Noetic"), "ros1"),
        ({"src/measure.py": OLD}, page("For ROS Noetic, or ROS 2 Humble"), "python"),
        ({"src/measure.py": OLD}, page("For ROS 2 Humble"), "python"),
        ({"src/measure.py": MEASURE}, page("It measures."), "python"),
        ({"src/measure.py": OLD.replace("'rosbag play a.bag'", "['rosbag', name]")}, page("For ROS Noetic"), "ros1"),
        ({"src/measure.py": OLD.replace("'rosbag play a.bag'", "to['rosbag']")}, page("For ROS Noetic"), "python"),
        ({"src/measure.py": MEASURE.replace("play = f", "# ")}, page("ROS 2 Galactic"), "python"),
        ({"src/measure.py": MEASURE.replace("play = f'", "print('")}, page("ROS 2 Galactic"), "python"),
        ({"src/measure.py": MEASURE.replace("subprocess", "numpy")}, page("ROS 2 Galactic"), "python"),
        (
            {"src/measure.py": MEASURE, "plot.py": "import numpy\n"},
            page("ROS 2 Galactic", "python3 plot.py\npython3 src/measure.py"),
            "python",
        ),
        ({"src/measure.py": f"import torch\n{MEASURE}"}, page("ROS 2 Galactic"), "cuda"),
    ],
)
def test_the_kind(tree: Tree, files: dict[str, str], text: str, kind: str) -> None:
    found = tree({**files, "README.md": text})
    assert found.kind == kind
    if kind == "ros2":
        assert (found.ros_distro, "ros-galactic-ros2bag" in found.apt_guessed) == ("galactic", True)
    else:
        assert not any(name.startswith("ros-galactic") for name in (*found.apt, *found.apt_guessed))


def test_the_package_of_a_program_that_it_starts(tree: Tree) -> None:
    run = "import yaml\nimport subprocess\nsubprocess.Popen('ros2 run {} perf_test', shell=True)\n"
    text = page("It uses ROS 2 Galactic.")
    for package, asked in (("performance_test", True), ("not_known_anywhere", False)):
        found = tree({"src/measure.py": run.format(package), "README.md": text})
        assert found.kind == "ros2"
        assert ("ros-galactic-performance-test" in found.apt_guessed) == asked
