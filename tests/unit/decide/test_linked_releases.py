"""The release of a library that a page names where it links to it, and what the image has beside a library."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GTSAM = "https://github.com/borglab/gtsam"
CODE = {"CMakeLists.txt": "project(demo)\nfind_package(GTSAM REQUIRED)\nadd_executable(demo a.cpp)\n", "a.cpp": ""}


@pytest.mark.parametrize(
    ("page", "ref"),
    [
        (f"- Download [GTSAM version 4.2a8]({GTSAM}/releases/tag/4.2a8)\n", "4.2a8"),
        (f"- [GTSAM]({GTSAM}) @ `4.2a9`\n", "4.2a9"),
        (f"- [GTSAM]({GTSAM}) (version 4.3a0)\n", "4.3a0"),
        (f"- [GTSAM]({GTSAM}): v4.2.1\n", "4.2.1"),
        # An older one of which the table has a newer that compiles
        (f"- [GTSAM]({GTSAM}/releases/tag/4.0.2)\n", "4.2"),
        (f"- [GTSAM]({GTSAM}) 4.2a8\n", "4.2"),  # nothing says that this is its release
        (f"- [GTSAM]({GTSAM}) version 4.2a8 or newer\n", "4.2"),
        (f"- [GTSAM]({GTSAM}) version 4.2a8+\n", "4.2"),
        (f"The fix is included in GTSAM [4.2a8]({GTSAM}/releases/tag/4.2a8)\n", "4.2"),
        (f"- Newer GTSAM, [4.2a8+]({GTSAM}/releases/tag/4.2a8)\n", "4.2"),
        (f"- [one]({GTSAM}/releases/tag/4.2a7), [two]({GTSAM}/releases/tag/4.2a8)\n", "4.2"),
        (f"- [our version of GTSAM]({GTSAM}/releases/tag/4.2a8)\n", "4.2"),
        (f"- [GTSAM]({GTSAM}/releases/tag/nightly)\n", "4.2"),
    ],
)
def test_the_release_that_a_page_links_to_is_built(tree: Tree, page: str, ref: str) -> None:
    decision = tree({**CODE, "README.md": f"Tested on Ubuntu 22.04\n# Installation\n{page}"})
    assert [(source.name, source.ref) for source in decision.source] == [("gtsam", ref)]


def test_the_page_that_builds_it_knows_better(tree: Tree) -> None:
    built = f"```\ngit clone -b 4.1.1 {GTSAM}\nmkdir gtsam/build && cd gtsam/build\ncmake ..\nsudo make install\n```\n"
    decision = tree({**CODE, "README.md": f"Ubuntu 22.04\n[GTSAM]({GTSAM}/releases/tag/4.2a8)\n{built}"})
    assert [(source.name, source.ref) for source in decision.source] == [("gtsam", "4.1.1")]


def test_a_library_that_no_table_has_is_built_at_the_tag_that_is_linked(tree: Tree) -> None:
    code = {
        "CMakeLists.txt": "project(demo)\nfind_package(acmelib REQUIRED)\nadd_executable(demo a.cpp)\n",
        "a.cpp": "",
    }
    page = "Install [acmelib 1.2](https://github.com/lab/acmelib/releases/tag/v1.2) first.\n"
    decision = tree({**code, "README.md": page})
    assert [(source.name, source.ref) for source in decision.source] == [("acmelib", "v1.2")]


@pytest.mark.parametrize(("asked", "eigen"), [("GTSAM", True), ("sophus", True), ("osqp", False)])
def test_the_image_has_eigen_where_the_headers_of_a_library_include_it(tree: Tree, asked: str, *, eigen: bool) -> None:
    made = f"project(demo)\nfind_package({asked} REQUIRED)\nadd_executable(demo a.cpp)\n"
    decision = tree({"CMakeLists.txt": made, "a.cpp": "int main() {}\n"})
    assert [source.name for source in decision.source] == [asked.lower()]
    assert ("libeigen3-dev" in {*decision.apt, *decision.apt_guessed}) == eigen


@pytest.mark.parametrize(
    ("said", "ref"),
    [
        ("GTSAM >= 4.1", "4.1.1"),
        ("**GTSAM 4.2.0** (pose graphs)", "4.2"),
        ("[GTSAM](https://gtsam.org) 4.2", "4.2"),
        ("gtsam 4.2a9 or newer", "4.2"),
        ("GTSAM 4.3a0", "4.3a0"),
        ("GTSAM 4.0.2", "4.0.3"),  # the one of the Ubuntu compiles there
        ("GTSAM 4.x", "4.0.3"),
        ("GTSAM 9", "4.0.3"),  # the table has none
        ("GTSAM 4.2 (optional)", "4.0.3"),
    ],
)
def test_a_list_asks_for_a_newer_release_than_the_ubuntu_has(tree: Tree, said: str, ref: str) -> None:
    decision = tree({**CODE, "README.md": f"Tested on Ubuntu 20.04\n## Dependencies\n- Eigen3\n- {said}\n"})
    assert [(source.name, source.ref) for source in decision.source] == [("gtsam", ref)]


def test_a_list_asks_for_nothing_that_ros_brings_or_cmake_does_not_look_for(tree: Tree) -> None:
    page = "ROS 2 Humble\n## Dependencies\n- GTSAM 4.3\n- Pangolin 0.9\n"
    manifest = "<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    assert not tree({**CODE, "package.xml": manifest, "README.md": page}).source
