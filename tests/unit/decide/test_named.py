"""Where a page names the packages that catkin builds, what else a clone holds is not built."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
MADE = "project({})\nfind_package(catkin REQUIRED)\n"
LIST = "- git: {local-name: maps, uri: 'https://github.com/lab/maps.git'}\n"
NEEDS = "<depend>maps_core</depend>"
FILES = {
    "demo/package.xml": PACKAGE.format("demo", NEEDS),
    "demo/CMakeLists.txt": MADE.format("demo"),
    "demo_msgs/package.xml": PACKAGE.format("demo_msgs", ""),
    "demo_msgs/CMakeLists.txt": MADE.format("demo_msgs"),
    "deps.rosinstall": LIST,
}


def page(command: str) -> str:
    return f"ROS Noetic\n```\nwstool merge demo/deps.rosinstall\n{command}\n```\n"


@pytest.mark.parametrize(
    ("command", "names"),
    [
        ("catkin build demo", ("demo", "demo_msgs")),
        ("catkin build demo --cmake-args -DA=B", ("demo", "demo_msgs")),
        ("catkin build maps\ncatkin build demo", ("demo", "demo_msgs", "maps")),
        ("catkin build demo_msgs\ncatkin build", ()),
        ("catkin build\ncatkin build demo", ("demo", "demo_msgs")),
        ("catkin build", ()),
        ("catkin build elsewhere", ()),
        ("catkin_make", ()),
    ],
)
def test_the_packages_that_the_page_builds(tree: Tree, command: str, names: tuple[str, ...]) -> None:
    assert tree(FILES | {"README.md": page(command)}).by_pages.packages == names


def test_all_is_built_where_a_launch_file_starts_what_no_manifest_names(tree: Tree) -> None:
    launch = '<launch><node pkg="{}" type="a" name="a"/></launch>'
    files = FILES | {"README.md": page("catkin build demo")}
    assert tree(files | {"demo/launch/a.launch": launch.format("maps_core")}).by_pages.packages == ("demo", "demo_msgs")
    assert tree(files | {"demo/launch/a.launch": launch.format("maps_viewer")}).by_pages.packages == ()


@pytest.mark.parametrize(("package", "all_of_it"), [("maps_core", False), ("maps", True), ("maps_viewer", True)])
def test_all_is_built_where_the_command_starts_what_is_not_named(
    tmp_path: Path, package: str, *, all_of_it: bool
) -> None:
    yaml = f"format: 3\ncommand: rosrun {package} show\n"
    for path, text in (FILES | {"README.md": page("catkin build demo"), "roslab.yaml": yaml}).items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    ros = plan_repository(tmp_path).plan.workspace.ros
    assert ros
    assert ros.named == (() if all_of_it else ("demo", "demo_msgs"))


def test_all_is_built_where_nothing_is_cloned(tree: Tree) -> None:
    files = {name: text.replace(NEEDS, "") for name, text in FILES.items() if name != "deps.rosinstall"}
    assert tree(files | {"README.md": page("catkin build demo")}).by_pages.packages == ()


def test_the_names_come_before_the_arguments_of_cmake(tmp_path: Path) -> None:
    for path, text in (FILES | {"README.md": page("catkin build demo")}).items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert '--parallel-packages "${jobs}" demo demo_msgs \\\n      --cmake-args' in text


AMENT = "<package><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend>{}</package>"
COLCON = {
    "demo/package.xml": AMENT.format("demo", NEEDS),
    "demo/CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
    "demo_msgs/package.xml": AMENT.format("demo_msgs", ""),
    "demo_msgs/CMakeLists.txt": "project(demo_msgs)\nfind_package(ament_cmake REQUIRED)\n",
    "deps.repos": "repositories:\n  maps: {type: git, url: 'https://github.com/lab/maps.git', version: main}\n",
}


@pytest.mark.parametrize(
    ("command", "names"),
    [
        ("colcon build --packages-up-to demo --symlink-install", ("demo", "demo_msgs")),
        ("colcon build --symlink-install --packages-up-to demo", ("demo", "demo_msgs")),
        ("colcon build --packages-up-to elsewhere", ()),
        ("colcon build --packages-up-to demo\ncolcon build --symlink-install", ()),
        ("colcon build --packages-select demo", ()),
        ("colcon build", ()),
    ],
)
def test_what_colcon_builds_where_a_page_builds_up_to_a_package(
    tree: Tree, command: str, names: tuple[str, ...]
) -> None:
    page = f"ROS 2 Humble\n```\nvcs import src < deps.repos\n{command}\n```\n"
    assert tree(COLCON | {"README.md": page}).by_pages.packages == names


def test_the_packages_that_colcon_builds_come_before_the_arguments_of_cmake(tmp_path: Path) -> None:
    page = "ROS 2 Humble\n```\nvcs import src < deps.repos\ncolcon build --packages-up-to demo\n```\n"
    for path, text in (COLCON | {"README.md": page}).items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "      --packages-up-to demo demo_msgs \\\n      --cmake-args" in text


@pytest.mark.parametrize(
    ("commands", "jobs"),
    [
        ("catkin_make -j1", 1),
        ("catkin_make -DCMAKE_BUILD_TYPE=Release -j 2", 2),
        ("catkin_make_isolated --install -j3", 3),
        ("catkin init\ncatkin config --extend /opt/ros/noetic\ncatkin build -j4 demo\ncatkin build --jobs=1", 4),
        ("catkin_make\ncatkin_make -j1", None),
        ("catkin_make -j$(nproc)", None),
        ("catkin_make -j", None),
        ("catkin_make", None),
    ],
)
def test_the_most_jobs_of_the_page(tmp_path: Path, commands: str, jobs: int | None) -> None:
    for path, text in (FILES | {"README.md": f"ROS Noetic\n```\n{commands}\n```\n"}).items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan).rpartition("\nEOF\n")[
        2
    ]  # below the scripts, which have jobs of their own
    assert (f'"$(compile-jobs {jobs})"' in text) == (jobs is not None)
    assert ('"$(compile-jobs)"' in text) == (jobs is None)
