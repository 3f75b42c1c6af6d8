"""What bounds a Python and what names one, and projects that pip installs on some Pythons alone."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.values.conda import conda_package, named_python

Tree = Callable[[dict[str, str]], Decision]
CODE = {"main.py": "import numpy\nif __name__ == '__main__':\n    pass\n"}
PROJECT = '[project]\nname = "demo"\nversion = "1"\nrequires-python = "{}"\ndependencies = ["numpy"]\n'


def _environment(line: str) -> str:
    return f"channels: [conda-forge]\ndependencies:\n  - {line}\n  - numpy\n"


@pytest.mark.parametrize(
    ("line", "named", "bounds"),
    [
        ("python=3.8", "3.8", ""),
        ("python==3.8.10", "3.8", ""),
        ("python 3.8", "3.8", ""),
        ("python = 3.8", "3.8", ""),
        ("python >=3.7", None, ">=3.7"),
        ("python>=3.7, <3.10", None, ">=3.7,<3.10"),
        ("conda-forge::python <=3.9", None, "<=3.9"),
        ("python", None, ""),
        ("python ~=3.8.0", None, "~=3.8.0"),
    ],
)
def test_only_a_bare_version_names_one(line: str, named: str | None, bounds: str) -> None:
    package = conda_package(line)
    assert package is not None
    assert (named_python([package]), package.bounds) == (named, bounds)


@pytest.mark.parametrize(
    ("line", "version"),
    [("python >=3.7", "3.10"), ("python <3.9", "3.8"), ("python >=3.11", "3.12"), ("python=3.7", "3.7")],
)
def test_a_bound_of_conda_leaves_the_preferred_one(tree: Tree, line: str, version: str) -> None:
    assert tree({**CODE, "environment.yml": _environment(line)}).python.version == version


def test_a_name_outside_what_the_project_requires_is_not_taken(tree: Tree) -> None:
    files = {**CODE, "pyproject.toml": PROJECT.format(">=3.10"), "ci/env.yml": _environment("python=3.8")}
    decision = tree({**files, "README.md": "```\nconda create -n demo python=3.8\npip install -e .\n```\n"})
    assert decision.python.version == "3.10"
    passed = [each for each in decision.reasons if (each.question, each.answer) == ("python", "3.8")]
    assert passed
    assert not any(each.decisive for each in passed)
    assert not [each for each in decision.warnings if "requires Python" in each.message]


def test_the_next_one_that_is_named_is_taken(tree: Tree) -> None:
    said = "Tested with Python 3.12.\n```\nconda create -n demo python=3.8\npip install -e .\n```\n"
    decision = tree({**CODE, "pyproject.toml": PROJECT.format(">=3.10"), "README.md": said})
    assert decision.python.version == "3.12"


def test_an_environment_that_is_made_keeps_its_python_and_is_told(tree: Tree) -> None:
    page = "```\nconda env create -f environment.yml\nconda activate demo\npip install -e .\n```\n"
    files = {"pyproject.toml": PROJECT.format(">=3.10"), "environment.yml": _environment("python=3.8")}
    decision = tree({**CODE, **files, "README.md": page})
    assert (decision.python.conda_file, decision.python.version) == ("environment.yml", "3.8")
    told = [each for each in decision.warnings if "requires Python >=3.10" in each.message]
    assert [(each.file, "has 3.8" in each.message) for each in told] == [("pyproject.toml", True)]


def test_the_python_of_ros_is_told_where_a_project_refuses_it(tree: Tree) -> None:
    package = "<package format='2'><name>a</name><version>1</version><description>a</description>"
    package += "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    package += "<buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
    files = {
        "a/package.xml": package,
        "a/CMakeLists.txt": "cmake_minimum_required(VERSION 3.0)\nproject(a)\nfind_package(catkin REQUIRED)\n",
        "demo/pyproject.toml": PROJECT.format(">=3.12"),
        "demo/demo/__init__.py": "",
        "README.md": "ROS Noetic\n```\ncd demo\npip install -e demo\n```\n",
    }
    decision = tree(files)
    assert decision.python.projects == ("demo",)
    assert [each.file for each in decision.warnings if "requires Python >=3.12" in each.message] == [
        "demo/pyproject.toml"
    ]
