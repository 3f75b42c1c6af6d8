"""A pin to a release that never was for the Python that all other pins need."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Net\n```\nconda create -n net python={}\npip install -r requirements.txt\n```\n"


@pytest.mark.parametrize(
    ("python", "others", "numpy", "loose"),
    [
        ("3.6", "scipy==1.2.1\ntorch==0.4.1\n", "numpy==1.22.0", ["numpy"]),
        ("3.6", "scipy==1.2.1\ntorch==0.4.1\n", "numpy==1.22.0; python_version >= '3.8'", []),
        ("3.6", "scipy==1.2.1\ntorch==0.4.1\n", "numpy==1.14.3", []),
        ("3.8", "torch==1.10.0\n", "numpy==1.22.0", []),
    ],
)
def test_one_pin_among_many(tree: Tree, python: str, others: str, numpy: str, loose: list[str]) -> None:
    asked = {"requirements.txt": f"{others}{numpy}\n", "README.md": PAGE.format(python)}
    found = tree({**asked, "main.py": "import numpy, torch\n"})
    assert found.python.version == python
    assert [each.written for each in found.python.pip if each.key == "numpy"] == loose
    assert found.python.requirements == (() if loose else ("requirements.txt",))
    assert any("numpy==1.22.0 needs Python 3.8" in told.message for told in found.warnings) == bool(loose)


def test_one_that_a_project_asks_for(tree: Tree) -> None:
    setup = "from setuptools import setup\nsetup(name='net', packages=['net'], install_requires=['torch==0.4.1', {}])\n"
    page = "# Net\n```\nconda create -n net python=3.6\npip install -e .\n```\n"
    found = tree({"setup.py": setup.format("'numpy==1.22.0'"), "net/__init__.py": "", "README.md": page}).python
    assert (found.alone, {each.written for each in found.pip}) == ((".",), {"torch==0.4.1", "numpy"})


@pytest.mark.parametrize("first", ["numpy==1.22.0\n{}", "{}numpy==1.22.0\n"])
@pytest.mark.parametrize("page", ["", PAGE.format("3.7")], ids=["no-page", "a-page"])
def test_most_pins_tell_the_python_wherever_the_one_stands(tree: Tree, first: str, page: str) -> None:
    asked = first.format("matplotlib==2.2.2\nscikit-image==0.14.2\nopencv-python==3.4.2.17\n")
    found = tree({"requirements.txt": asked, "README.md": page, "main.py": "import numpy\n"}).python
    assert found.version == "3.7"
    assert [each.written for each in found.pip if each.key == "numpy"] == ["numpy"]


ROS = {
    "package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "README.md": "Tested on ROS Noetic.\n",
    "scripts/show.py": "#!/usr/bin/env python3\nimport rospy, scipy\n",
}


@pytest.mark.parametrize(
    ("scipy", "loose"),
    [
        ("scipy>=1.16.2", ["scipy"]),
        ("scipy>=1.16.2; python_version >= '3.11'", []),
        ("scipy>=1.5", []),
        ("scipy>=1.5,<1.17", []),
    ],
)
def test_a_lower_bound_that_no_release_for_the_python_of_ros_meets(tree: Tree, scipy: str, loose: list[str]) -> None:
    found = tree({**ROS, "requirements.txt": f"qpsolvers\n{scipy}\n"})
    assert [each.written for each in found.python.pip if each.key == "scipy"] == loose
    assert found.python.requirements == (() if loose else ("requirements.txt",))
    assert any("scipy>=1.16.2 needs Python 3.11" in told.message for told in found.warnings) == bool(loose)


def test_of_two_the_first_counts(tree: Tree) -> None:
    found = tree({"requirements.txt": "numpy==1.22.0\nmatplotlib==2.2.2\n", "main.py": "import numpy\n"}).python
    assert found.version in {"3.8", "3.9", "3.10"}


def test_many_that_are_trusted_less_do_not_outvote_a_list(tree: Tree) -> None:
    page = "```\npip install matplotlib==2.2.2 scikit-image==0.14.2 opencv-python==3.4.2.17\n```\n"
    found = tree({"requirements.txt": "numpy==1.22.0\n", "README.md": page, "main.py": "import numpy\n"}).python
    assert found.version in {"3.8", "3.9", "3.10"}


@pytest.mark.parametrize(
    ("asked", "loose", "needs"),
    [
        ("pytest-html>=2.0.1", ["pytest-html"], "newer than 3.5"),
        ("pytest-html==3.2.0", ["pytest-html"], "newer than 3.5"),
        ("pytest-html>=2.0.1; python_version >= '3.6'", [], ""),
        ("pytest-html>=1.20", [], ""),
        ("pytest-html", [], ""),
    ],
)
def test_a_release_after_the_last_for_the_python_of_ros(tree: Tree, asked: str, loose: list[str], needs: str) -> None:
    found = tree({**ROS, "README.md": "Tested on ROS Kinetic.\n", "requirements.txt": f"yacs\n{asked}\n"})
    assert found.ros_distro == "kinetic"
    assert [each.written for each in found.python.pip if each.key == "pytest-html"] == loose
    assert found.python.requirements == (() if loose else ("requirements.txt",))
    told = f"{asked} needs a Python {needs}, and the image has 3.5"
    assert any(told in warning.message for warning in found.warnings) == bool(loose)


@pytest.mark.parametrize(
    ("asked", "python"),
    [
        ("gymnasium==1.2.0\nnumpy>=1.16", {"3.10", "3.11", "3.12"}),
        ("gymnasium>=0.29\ntorch==1.13.1\n", {"3.8", "3.9", "3.10"}),
        ("gymnasium==0.26.3\ntorch==1.8.0\n", {"3.6", "3.7", "3.8", "3.9"}),
    ],
)
def test_it_tells_the_python_where_nothing_names_one(tree: Tree, asked: str, python: set[str]) -> None:
    found = tree({"requirements.txt": asked, "main.py": "import gymnasium\n"})
    assert found.python.version in python
    told = any("needs a Python newer than" in r.reason for r in found.reasons if r.question == "python")
    assert told == ("0.26.3" not in asked)


@pytest.mark.parametrize(
    ("files", "tried"),
    [
        ({"requirements.txt": "numpy==1.24.4\nnobody==0.1.40\n"}, ["numpy", "nobody==0.1.40"]),
        ({"requirements.txt": "numpy==1.16.0\nnobody==0.1.40\n"}, []),
        ({"requirements.txt": "numpy==1.24.4; python_version >= '3.8'\nnobody==0.1.40\n"}, []),
    ],
)
def test_the_other_lines_of_such_a_list_stop_no_image_of_ros(
    tree: Tree, files: dict[str, str], tried: list[str]
) -> None:
    found = tree({**ROS, "README.md": "Tested on ROS Melodic.\n", **files})
    assert [each.written for each in found.python.pip_tried] == tried
    said = "requirements.txt is for a newer Python than the 3.6 of ROS"
    assert any(said in told.message for told in found.warnings) == bool(tried)


def test_but_that_of_a_chosen_python_does(tree: Tree) -> None:
    asked = {"requirements.txt": "scipy==1.2.1\ntorch==0.4.1\nnumpy==1.22.0\n", "README.md": PAGE.format("3.6")}
    found = tree({**asked, "main.py": "import numpy, torch\n"})
    assert found.python.version == "3.6"
    assert not found.python.pip_tried
