"""What no program of the tree asks for: libraries of C by the names of modules, and what only Sphinx calls."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(catkin REQUIRED)\n"
CONF = "import os\nimport cairo\nos.system('doxygen Doxyfile')\n{}\n"


@pytest.mark.parametrize(
    ("module", "library"), [("cairo", "libcairo2-dev"), ("ceres", "libceres-dev"), ("zlib", "zlib1g-dev")]
)
def test_an_import_asks_for_no_library_of_c(tree: Tree, module: str, library: str) -> None:
    files = {"package.xml": PACKAGE, "README.md": "ROS Noetic\n", "scripts/draw.py": f"import rospy\nimport {module}\n"}
    decision = tree({**files, "CMakeLists.txt": CMAKE})
    assert library not in {*decision.apt, *decision.apt_guessed}
    linked = tree({**files, "CMakeLists.txt": f"{CMAKE}find_package({module} REQUIRED)\n"})
    assert library in {*linked.apt, *linked.apt_guessed}


@pytest.mark.parametrize(
    ("sphinx", "called"), [("html_theme = 'alabaster'", False), ("master_doc = 'index'", False), ("", True)]
)
@pytest.mark.parametrize("folder", ["guide", "manual"])
def test_what_sphinx_alone_reads_needs_nothing(tree: Tree, folder: str, sphinx: str, called: bool) -> None:
    decision = tree({f"{folder}/conf.py": CONF.format(sphinx), "run.py": "import six\nprint(six)\n"})
    assert ("doxygen" in {*decision.apt, *decision.apt_guessed}) == called
    assert ("pycairo" in {each.key for each in decision.python.pip_guessed}) == called


def test_a_folder_of_read_the_docs_is_documentation(tree: Tree) -> None:
    decision = tree({"readthedocs/conf.py": CONF.format(""), "run.py": "import six\nprint(six)\n"})
    assert "doxygen" not in {*decision.apt, *decision.apt_guessed}
