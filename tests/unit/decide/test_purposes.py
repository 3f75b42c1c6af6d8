"""What only serves or looks at another program is the one that is meant where its package or repository is for it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = (
    "<package format='2'><name>{}</name><version>0.1.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>catkin</buildtool_depend></package>"
)
CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject({})\nfind_package(catkin REQUIRED)\ncatkin_package()\n"


def of_ros(package: str, *launched: str) -> dict[str, str]:
    launch = f"<launch><node pkg='{package}' type='a' name='a'/></launch>\n"
    return {
        "package.xml": PACKAGE.format(package),
        "CMakeLists.txt": CMAKE.format(package) + "add_executable(a a.cpp)\n",
        "a.cpp": "int main() {}\n",
        **{f"launch/{name}.launch": launch for name in launched},
    }


@pytest.mark.parametrize(
    ("package", "launched", "meant"),
    [
        ("multi_calibration", "calibration", True),
        ("multi_calibration", "calibrate", True),
        ("arm_teleop", "teleop", True),
        ("arm_teleop", "teleop_joy", True),
        ("arm_generator", "generate", True),
        ("arm_teleop", "calibration", False),
        ("arm", "teleop", False),
        ("eva", "evaluate", False),
        ("arm_setup", "update", False),
    ],
)
def test_a_word_of_the_package_s_name_is_what_it_is_for(
    tree: Tree, package: str, launched: str, *, meant: bool
) -> None:
    page = (
        f"ROS Noetic\n\n# Setting\n```\nroslaunch {package} {launched}.launch\nroslaunch {package} other.launch\n```\n"
    )
    name = launched if meant else "other"
    command = tree({**of_ros(package, launched, "other"), "README.md": page}).command
    assert command == ("roslaunch", package, f"{name}.launch")


def test_one_package_of_several_may_serve_the_others(tree: Tree) -> None:
    maps = {f"maps/{path}": text for path, text in of_ros("map_generator", "generate").items()}
    page = "ROS Noetic\n\n# Usage\n```\nroslaunch map_generator generate.launch\nroslaunch flight fly.launch\n```\n"
    flight = {f"flight/{path}": text for path, text in of_ros("flight", "fly").items()}
    assert tree({**maps, **flight, "README.md": page}).command == ("roslaunch", "flight", "fly.launch")


@pytest.mark.parametrize(
    ("repository", "program", "meant"),
    [
        ("traj_eval", "evaluate.py", True),
        ("traj-evaluation", "evaluate.py", True),
        ("traj", "evaluate.py", False),
        ("plotter", "plot_all.py", True),
        ("bag_converter", "convert.py", True),
        ("build_docker", "build.py", False),
    ],
)
def test_a_word_of_the_repository_s_name(tmp_path: Path, repository: str, program: str, *, meant: bool) -> None:
    page = f"# Programs\n```\npython3 {program}\npython3 other.py\n```\n"
    for path, text in {
        "README.md": page,
        ".git/config": f'[remote "origin"]\n\turl = https://github.com/lab/{repository}.git\n',
        ".git/HEAD": "ref: refs/heads/main\n",
        program: "if __name__ == '__main__':\n    print(1)\n",
        "other.py": "if __name__ == '__main__':\n    print(2)\n",
    }.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    assert plan_repository(tmp_path).plan.run.command == ("python3", program if meant else "other.py")


@pytest.mark.parametrize(
    ("page", "found"),
    [
        ("# Usage\n```\nroslaunch demo calibration.launch\n```\n", "roslaunch demo calibration.launch"),
        ("# Parts\n```\nroslaunch demo calibration.launch\n```\n", "bash"),
        ("# Usage\n```\nroslaunch demo calibration.launch\nroslaunch demo plot.launch\n```\n", "bash"),
        ("# Usage\n```\nroslaunch demo convert.launch\n```\n", "bash"),
    ],
)
def test_the_only_launch_file_of_a_section_about_use(tree: Tree, page: str, found: str) -> None:
    files = of_ros("demo", "calibration", "convert", "plot", "one", "two")
    assert " ".join(tree({**files, "README.md": f"ROS Noetic\n{page}"}).command) == found
