"""Packages that no package.xml names, and that the build looks for in the lists of what it clones."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
LAB = "https://github.com/lab"
MANIFEST = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
NODE = '<node pkg="demo" type="demo_node" name="demo"/>'


def _files(components: str = "", launch: str = "", page: str = f"cd src\ngit clone {LAB}/stack\n") -> dict[str, str]:
    return {
        "package.xml": MANIFEST,
        "CMakeLists.txt": f"project(demo)\nfind_package(catkin REQUIRED COMPONENTS roscpp {components})\n"
        "add_executable(demo_node demo.cpp)\n",
        "demo.cpp": "int main() {}\n",
        "launch/demo.launch": f"<launch>{launch}{NODE}</launch>\n",
        "README.md": f"ROS Noetic\n```\n{page}catkin_make\nroslaunch demo demo.launch\n```\n",
    }


@pytest.mark.parametrize(
    ("components", "launch", "wanted"),
    [
        ("speech_msgs", "", ("speech_msgs",)),
        ("", '<include file="$(find robots)/a.launch"/>', ("robots",)),
        ("speech_msgs", '<include file="$(find robots)/a.launch"/>', ("robots", "speech_msgs")),
        ("std_msgs", '<include file="$(find rviz)/a.launch"/>', ()),
    ],
)
def test_what_cmake_and_the_default_launch_file_need(
    tree: Tree, components: str, launch: str, wanted: tuple[str, ...]
) -> None:
    assert tree(_files(components, launch)).wanted == wanted


def test_what_is_tried_for_other_launch_files(tree: Tree) -> None:
    files = _files() | {"launch/other.launch": '<launch><include file="$(find crowd_world)/a.launch"/></launch>\n'}
    git = f'[remote "origin"]\n\turl = {LAB}/demo.git\n'
    files |= {".git/config": git, "README.md": _files(page="")["README.md"]}
    assert tree(files).wanted == ("crowd_world",)


def test_what_a_package_xml_names_is_told_by_rosdep(tree: Tree) -> None:
    files = _files("speech_msgs")
    files["package.xml"] = MANIFEST.replace("</package>", "<depend>speech_msgs</depend></package>")
    assert not tree(files).wanted


@pytest.mark.parametrize("cloned", [True, False])
def test_the_build_looks_for_it_where_it_clones_something(tmp_path: Path, cloned: bool) -> None:
    files = _files("", '<include file="$(find robots)/a.launch"/>')
    tree_of(tmp_path, files if cloned else files | {"README.md": _files(page="")["README.md"]})
    made = dockerfile(plan_repository(tmp_path).plan)
    assert ("install-rosdep-keys --tables noetic/final --complete --want robots " in made) is cloned
