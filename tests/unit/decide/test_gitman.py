"""A collection of repositories without code of its own: what gitman lists, and what only scripts fetch."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LIST = """\
location: .gitman
sources:
  - repo: https://github.com/lab/driver.git
    name: my_driver
    rev: master
    type: git
    link: ros_packages/driver
    links:
      -
  - repo: git@github.com:lab/maps.git
    name:
    rev: v1.2
"""
LOCKED = """\
sources_locked:
  - repo: https://github.com/lab/driver.git
    name: my_driver
    rev: b566f9b9cef82f1f69508fd45b59e63c8a27b817
"""
CI = {
    ".github/workflows/noetic.yml": "name: Noetic\njobs:\n  build:\n    runs-on: ubuntu-20.04\n    steps:\n"
    "      - run: source /opt/ros/noetic/setup.bash && catkin build\n"
}


@pytest.mark.parametrize("name", [".gitman.yml", "gitman.yml"])
def test_what_gitman_lists_is_cloned_at_what_it_locked(tree: Tree, name: str) -> None:
    decision = tree({name: LIST + LOCKED, **CI})
    assert (decision.kind, decision.ros_distro, decision.build_tool) == ("ros1", "noetic", "catkin_tools")
    assert [(source.name, source.repo, source.ref) for source in decision.source] == [
        ("my_driver", "https://github.com/lab/driver.git", "b566f9b9cef82f1f69508fd45b59e63c8a27b817"),
        ("maps", "https://github.com/lab/maps.git", "v1.2"),
    ]


@pytest.mark.parametrize(
    ("script", "lists"),
    [
        ("gitman install core", True),
        ("cd x && gitman update", True),
        ("gitman install", True),
        ("git submodule update --init", False),
        ("echo gitman install", False),
    ],
)
def test_what_a_listed_repository_lists_is_cloned_where_gitman_is_called_in_it(
    tree: Tree, script: str, lists: bool
) -> None:
    text = LIST.replace("    links:\n      -\n", f"    scripts:\n      - {script}\n")
    decision = tree({"gitman.yml": text + LOCKED, **CI})
    assert [(source.name, source.lists) for source in decision.source] == [("my_driver", lists), ("maps", False)]


def test_a_list_of_gitman_alone_is_of_no_ros(tree: Tree) -> None:
    decision = tree({".gitman.yml": LIST, "CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\n"})
    assert decision.kind == "cpp"
    assert tree({"below/.gitman.yml": LIST}).source == ()


FETCH = {"install.sh": "#!/bin/bash\ngit clone https://github.com/lab/core.git\ncd core\n./install.sh\n"}


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        (FETCH | CI, "ros1"),
        (FETCH | CI | {"a.py": "import numpy\n"}, "python"),
        (FETCH | CI | {"CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\n"}, "cpp"),
        (FETCH | {"README.md": "Works with ROS Noetic.\n"}, "python"),
        (FETCH | {"README.md": "Works with ROS Noetic and with ROS 2 Humble.\n```\ncatkin build\n```\n"}, "python"),
        (FETCH | {"README.md": "Works with ROS 2 Humble.\n```\ncolcon build\n```\n"}, "ros2"),
    ],
)
def test_a_tree_without_code_is_what_its_scripts_build(tree: Tree, files: dict[str, str], kind: str) -> None:
    assert tree(files).kind == kind
