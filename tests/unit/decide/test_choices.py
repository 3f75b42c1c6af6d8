"""Files of which a page lets its reader start any, and lists whose launch files are named like benchmarks."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.lex.choices import with_first_choice

Tree = Callable[[dict[str, str]], Decision]
NAMES = ("rviz", "bench_a", "bench_b", "simulator", "dock", "calibrate")
FILES = {
    "package.xml": "<package><name>plan</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(plan)\nfind_package(catkin REQUIRED)\n",
    **{f"launch/{name}.launch": "<launch/>" for name in NAMES},
}


@pytest.mark.parametrize(
    ("line", "first"),
    [
        ("1. roslaunch plan a.launch  or  b.launch   or c.launch  (test)", "1. roslaunch plan a.launch  (test)"),
        ("roslaunch plan a.launch / b.launch", "roslaunch plan a.launch"),
        ("roslaunch plan a.launch, b.launch, or c.launch", "roslaunch plan a.launch"),
        ("roslaunch plan a.launch or roslaunch plan b.launch", "roslaunch plan a.launch"),
        ("roslaunch plan a.launch / roslaunch plan b.launch", "roslaunch plan a.launch"),
        ("roslaunch plan a.launch, or roslaunch plan b.launch", "roslaunch plan a.launch"),
        ("roslaunch plan a.launch, roslaunch plan b.launch", None),
        ("python3 src/a.py, python3 src/b.py", None),
        ("ros2 launch plan a.launch.py or b.launch.py", "ros2 launch plan a.launch.py"),
        ("ros2 launch plan a_launch.py or plan b_launch.py", "ros2 launch plan a_launch.py"),
        ("python3 src/a.py or src/b.py", "python3 src/a.py"),
        ("python3 run_[a|b].py or run_c.py", "python3 run_a.py"),
        ("roslaunch plan a.launch\nor b.launch", None),
        ("roslaunch plan a.launch b.launch", None),
        ("roslaunch plan a.launch map:=x or so", None),
        ("roslaunch plan a.launch or press a key", None),
        ("python3 a.py --or b.py", None),
        ("`roslaunch plan a.launch` or `roslaunch plan b.launch`", None),
    ],
)
def test_the_first_of_several_files(line: str, first: str | None) -> None:
    assert with_first_choice(line) == (line if first is None else first)


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        (("plan rviz.launch  (to see it)", "plan bench_a.launch", "plan bench_b.launch"), "plan bench_a.launch"),
        (("plan rviz.launch", "plan bench_b.launch or bench_a.launch"), "plan bench_b.launch"),
        (("plan rviz.launch", "plan bench_a.launch", "plan dock.launch"), "plan dock.launch"),
        (("plan rviz.launch", "plan calibrate.launch"), "plan calibrate.launch"),
        (("plan bench_a.launch", "plan calibrate.launch"), ""),
    ],
)
@pytest.mark.parametrize("title", ["Run Simulation", "Benchmarks"])
def test_a_list_of_launch_files(tree: Tree, lines: tuple[str, ...], command: str, title: str) -> None:
    listed = "\n".join(f"{number}. roslaunch {line}" for number, line in enumerate(lines, 1))
    page = f"# Plan\nFor ROS Noetic.\n\n## {title}\n\n{listed}\n"
    meant = command if title != "Benchmarks" or "dock" in command else ""
    assert " ".join(tree({**FILES, "README.md": page}).command) == (f"roslaunch {meant}" if meant else "bash")
