"""Repositories that a page lists as required, with their branches."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]

THIRD = "https://github.com/third"
TITLE = "# Prerequisites\nROS 2 Humble. The following repositories are required:\n"


def _files(page: str, code: str) -> dict[str, str]:
    export = "<export><build_type>ament_cmake</build_type></export>"
    return {
        "README.md": page,
        "package.xml": '<package format="3"><name>tether</name>'
        f"<buildtool_depend>ament_cmake</buildtool_depend>{export}</package>",
        "CMakeLists.txt": "project(tether)\nfind_package(ament_cmake REQUIRED)\ninstall(PROGRAMS scripts/a.py)\n",
        "scripts/a.py": f"import rclpy\n{code}\nrclpy.init()\n",
    }


def _cloned(decision: Decision) -> dict[str, str | None]:
    return {source.repo or "": source.ref for source in decision.source}


@pytest.mark.parametrize(
    ("item", "ref"),
    [
        (f"- quad_x: ({THIRD}/quad_x, branch: humble-devel)\n", "humble-devel"),
        (f"- quad_x: ({THIRD}/quad_x/tree/ros2, branch: ros2)\n", "ros2"),
        (f"- [quad_x]({THIRD}/quad_x) (galactic branch)\n", "galactic"),
        (f"- [quad_x]({THIRD}/quad_x), branch `lab/new`.\n", "lab/new"),
        (f"- [quad_x]({THIRD}/quad_x) is a branch of our work\n", None),
        (f"- [quad_x]({THIRD}/quad_x) and [more]({THIRD}/more) (branch: old)\n", None),
        (f"- [quad_x]({THIRD}/quad_x) (default branch)\n", None),
        (f"- [quad_x]({THIRD}/quad_x), branch: please see their page.\n", None),
        (f"- [quad_x]({THIRD}/quad_x), branch: default.\n", None),
        (f"- [quad_x]({THIRD}/quad_x), branch: new-devel\n", "new-devel"),
        (f"- [quad_x]({THIRD}/quad_x) (other branch), now branch: `ros2`\n", "ros2"),
    ],
)
@pytest.mark.parametrize("code", ["from quad_x.srv import Attach", "import quad_x.msg", "from quad_x.action import *"])
def test_messages_that_a_script_imports_are_of_a_package_that_a_page_lists(
    tree: Tree, item: str, ref: str | None, code: str
) -> None:
    assert _cloned(tree(_files(TITLE + item, code))) == {f"{THIRD}/quad_x": ref}


@pytest.mark.parametrize(
    ("link", "ref"),
    [
        ("tree/main/quad_x_msgs", "default"),
        ("tree/humble-devel/ros/quad_x_msgs", "humble-devel"),
        ("tree/master/quad_x_msgs/", "default"),
        ("-/tree/v2/quad_x_msgs", "v2"),
        ("tree/main/quad_x_msgs/README.md", None),
        ("blob/main/quad_x_msgs", None),
        ("tree/main/quad_x_msgs?tab=readme", "default"),
    ],
)
def test_a_listed_folder_of_a_repository_is_of_that_repository(tree: Tree, link: str, ref: str | None) -> None:
    page = f"{TITLE}- quad_x: {THIRD}/quad_x/{link}\n"
    cloned = _cloned(tree(_files(page, "from quad_x_msgs.srv import Attach")))
    assert cloned == ({f"{THIRD}/quad_x": None if ref == "default" else ref} if ref else {})
    page = f"ROS 2 Humble. It is like {THIRD}/quad_x/{link}\n"
    assert _cloned(tree(_files(page, "from quad_x_msgs.srv import Attach"))) == {}


@pytest.mark.parametrize(
    "code",
    ["def run():\n    from quad_x.srv import Attach", "from quad_x import srv", "from std_msgs.msg import String"],
)
def test_what_is_no_import_of_messages_clones_nothing(tree: Tree, code: str) -> None:
    assert _cloned(tree(_files(f"{TITLE}- [quad_x]({THIRD}/quad_x)\n", code))) == {}


def test_messages_of_no_package_that_anything_names_are_told(tree: Tree) -> None:
    decision = tree(_files("ROS 2 Humble\n", "from quad_x.srv import Attach"))
    told = [(each.file, each.line) for each in decision.warnings if "imports messages of quad_x" in each.message]
    assert told == [("scripts/a.py", 2)]


def test_they_are_sought_with_the_owner(tree: Tree) -> None:
    files = _files("ROS 2 Humble\n", "from quad_x.srv import Attach")
    files |= {
        ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/tether\n',
        ".git/HEAD": "ref: refs/heads/a\n",
    }
    decision = tree(files)
    assert [(source.repo, source.holding) for source in decision.source] == [
        ("https://github.com/lab/quad_x.git", ("quad_x",))
    ]
    assert any("looks for it in https://github.com/lab/quad_x" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("item", "fork"),
    [
        (f"- sjtu_drone: ({THIRD}/sjtu_drone/tree/ros2)\n", True),
        (f"- sjtu_drone: ({THIRD}/sjtu_drone)\n", False),
        ("- something else\n", False),
    ],
)
def test_a_listed_fork_with_a_branch_comes_before_a_table(tree: Tree, item: str, fork: bool) -> None:
    files = _files(TITLE + item, "")
    files["package.xml"] = files["package.xml"].replace("<export>", "<depend>sjtu_drone_bringup</depend><export>")
    files["CMakeLists.txt"] += "find_package(sjtu_drone_bringup REQUIRED)\n"
    cloned = _cloned(tree(files))
    assert (f"{THIRD}/sjtu_drone" in cloned) is fork
    assert len(cloned) == 1
