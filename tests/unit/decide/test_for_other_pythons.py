"""Pins of a freeze that no release for the image's Python meets, and backports that this Python has itself."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.too_new import unmet
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
CODE = {"run.py": "import torch\n"}
NODE = """\
<package format="3"><name>a</name><version>1.0.0</version><description>x</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>
<buildtool_depend>ament_cmake</buildtool_depend><depend>rclpy</depend></package>
"""
CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject(a)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
PAGE = "```\nconda create -n a python={}\npip install -r requirements.txt\n```\n"


def _written(decision: Decision) -> list[str]:
    return [each.written for each in decision.python.pip]


@pytest.mark.parametrize(
    ("lines", "python"),
    [
        ("torch==1.7.1\ndataclasses==0.8\nnumpy==1.19.5\n", "3.6"),  # all of them fit
        ("torch==1.11.0\ndataclasses==0.8\npandas==1.2.5\n", "3.8"),  # most of them do
        ("torch==1.11.0\ndataclasses==0.6\n", "3.10"),  # it is for any
        ("torch==1.11.0\ndataclasses==0.8; python_version < '3.7'\n", "3.10"),  # for no other
        ("torch==1.13.1\npyarrow==5.0.0\n", "3.8"),
        ("torch==1.13.1\npyarrow==6.0.1\n", "3.10"),
    ],
)
def test_the_python_that_most_pins_fit(tree: Tree, lines: str, python: str) -> None:
    assert tree({**CODE, "requirements.txt": lines}).python.version == python


@pytest.mark.parametrize(
    "line", ["dataclasses==0.8", "enum34==1.1.10", "futures==3.1.1", "contextvars==2.4", "pathlib==1.0.1"]
)
def test_what_the_python_has_itself_is_left_out(tree: Tree, line: str) -> None:
    decision = tree({**CODE, "requirements.txt": f"torch==1.11.0\n{line}\n", "README.md": PAGE.format("3.8")})
    assert (decision.python.version, decision.python.requirements) == ("3.8", ())
    assert _written(decision) == ["torch==1.11.0"]
    (said,) = [each for each in decision.warnings if each.message.startswith(f"{line} is left out: Python 3.")]
    assert (said.file, said.line) == ("requirements.txt", 2)
    assert said.message.endswith(" and newer have it themselves, and the image has 3.8")


def test_so_is_what_a_page_installs_or_a_project_needs(tree: Tree) -> None:
    files = {
        "setup.py": "from setuptools import setup\nsetup(name='a', install_requires=['enum34', 'six'])\n",
        "a/__init__.py": "import six\n",
        "README.md": "```\npip install futures tqdm\npip install -e .\n```\n",
    }
    decision = tree(files)
    assert _written(decision) == ["six"]
    assert decision.python.alone == (".",)
    assert [each.written for each in decision.python.pip_guessed] == ["tqdm"]


@pytest.mark.parametrize("line", ["enum34==1.1.10", "dataclasses==0.8"])
def test_an_older_python_gets_it(tree: Tree, line: str) -> None:
    python = "2.7" if line.startswith("enum") else "3.6"
    decision = tree({**CODE, "requirements.txt": f"{line}\n", "README.md": PAGE.format(python)})
    assert (decision.python.version, decision.python.requirements) == (python, ("requirements.txt",))


def test_a_marker_for_older_ones_leaves_the_list_as_it_is(tree: Tree) -> None:
    lines = "torch==1.11.0\nenum34==1.1.10; python_version < '3.4'\n"
    assert tree({**CODE, "requirements.txt": lines}).python.requirements == ("requirements.txt",)


@pytest.mark.parametrize(
    ("line", "taken", "python"),
    [
        ("torch==1.7.1", "torch", "3.9"),
        ("torch==1.7.1+cu110", "torch", "3.9"),
        ("pyarrow==5.0.0", "pyarrow", "3.9"),
        ("torch==1.13.1", "", ""),
        ("torch>=1.7.1", "", ""),
        ("numpy==1.19.5", "", ""),  # pip compiles it
    ],
)
def test_a_pin_without_wheel_and_source_is_told(tree: Tree, line: str, taken: str, python: str) -> None:
    files = {
        "package.xml": NODE,
        "CMakeLists.txt": CMAKE,
        "requirements.txt": f"six\n{line}\n",
        "README.md": "# For ROS 2 Humble\n",
    }
    decision = tree(files)
    assert decision.ros_distro == "humble"
    told = [each for each in decision.warnings if each.message.startswith(f"{line} has no wheel for a Python newer")]
    assert bool(told) == bool(taken)
    if taken:
        assert (told[0].file, told[0].line) == ("requirements.txt", 2)
        assert f"newer than {python}, and no source, and the image has 3.10" in told[0].message
        assert _written(decision) == ["six", taken]


@pytest.mark.parametrize(
    ("line", "python", "ended"),
    [
        ("torch==1.12.1", "3.11", True),
        ("torch==1.13.1", "3.11", False),  # torchvision has none there
        ("torch==2.4.1", "3.13", True),
        ("torch==2.5.1", "3.13", False),
        ("tensorflow-gpu==2.4.0", "3.9", True),
    ],
)
def test_some_releases_have_a_wheel_for_one_python_more(line: str, python: str, *, ended: bool) -> None:
    assert unmet(stated(line), python) == ended
