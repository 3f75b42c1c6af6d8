"""What a page launches of the repository itself comes before a demonstration of something else, whatever its title."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
DEMO = ("roslaunch", "ar_demo", "bag.launch")
OWN = ("roslaunch", "vio_estimator", "euroc.launch")


def package(name: str, *launches: str) -> dict[str, str]:
    return {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>",
        f"{name}/CMakeLists.txt": f"cmake_minimum_required(VERSION 3.0)\nproject({name})\n"
        f"find_package(catkin REQUIRED)\nadd_executable({name}_node a.cpp)\n",
        f"{name}/a.cpp": "int main() {}\n",
        **{
            f"{name}/launch/{each}.launch": f'<launch><node pkg="{name}" type="{name}_node" name="a"/></launch>\n'
            for each in launches
        },
    }


@pytest.mark.parametrize(
    ("origin", "first", "command"),
    [
        ("VIO-Mono", "roslaunch vio_estimator euroc.launch", OWN),
        ("AR-Mono", "roslaunch vio_estimator euroc.launch", DEMO),
        ("other", "roslaunch vio_estimator euroc.launch", DEMO),
        ("VIO-Mono", "rosrun vio_estimator vio_estimator_node", DEMO),
        ("VIO-Mono", "", DEMO),
    ],
)
def test_it_is_the_default(tree: Tree, origin: str, first: str, command: tuple[str, ...]) -> None:
    page = f"# It\nROS Noetic\n## 3. Public data sets\n```\n{first}\n```\n"
    page += "## 4. AR Demo\n```\nroslaunch ar_demo bag.launch\n```\n"
    git = f'[remote "origin"]\n\turl = https://github.com/lab/{origin}.git\n'
    files = {"README.md": page, ".git/config": git, ".git/HEAD": "ref: refs/heads/main\n"}
    assert tree(files | package("vio_estimator", "euroc") | package("ar_demo", "bag")).command == command
