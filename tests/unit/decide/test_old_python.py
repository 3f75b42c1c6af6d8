"""Code that uses what newer Pythons dropped gets one that still has it, where nothing names another."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FORMAT = "print(f'{1}')\n"


@pytest.mark.parametrize(
    ("code", "python"),
    [
        ("import numpy\n", "3.10"),
        ("from collections import OrderedDict, Iterable\n", "3.8"),
        ("import collections\nclass A(collections.MutableSet):\n    pass\n", "3.8"),
        ("import collections.abc\nclass A(collections.abc.MutableSet):\n    pass\n", "3.10"),
        (
            "try:\n    from collections.abc import Mapping\nexcept ImportError:\n    from collections import Mapping\n",
            "3.10",
        ),
        ("# from collections import Iterable\n", "3.10"),
        ("x = x.cuda(async=True)\n", "3.6"),
        ("from fractions import gcd\n", "3.8"),
        ("import inspect\ninspect.getargspec(f)\n", "3.10"),
        (FORMAT + "from fractions import gcd\n", "3.8"),
    ],
)
def test_what_newer_pythons_dropped(tree: Tree, code: str, python: str) -> None:
    assert tree({"a.py": code, "requirements.txt": "numpy\n"}).python.version == python


@pytest.mark.parametrize("named", ["Python 3.10", "NumPy"])
def test_the_author_knows_better(tree: Tree, named: str) -> None:
    files = {"a.py": "import time\ntime.clock()\n", "README.md": f"Needs {named}.\n", "requirements.txt": "numpy\n"}
    found = tree({**files, "setup.py": "from setuptools import setup\nsetup(name='a', python_requires='>=3.9')\n"})
    assert found.python.version == "3.10"


def test_a_node_has_the_python_of_its_distribution(tree: Tree) -> None:
    manifest = "<package format='3'><name>a</name><export><build_type>ament_python</build_type></export></package>"
    files = {
        "package.xml": manifest,
        "setup.py": "from setuptools import setup\nsetup()\n",
        "README.md": "ROS Humble\n",
    }
    found = tree({**files, "a/node.py": "import rclpy\nfrom collections import Iterable\n"})
    assert (found.ros_distro, found.ubuntu) == ("humble", "jammy")


@pytest.mark.parametrize(("page", "python"), [("", "2.7"), ("Needs Python 3.6.\n", None)])
def test_what_a_newer_python_lost_tells_nothing_of_the_python_of_nodes(
    tree: Tree, page: str, python: str | None
) -> None:
    files = {
        "package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\n",
        "README.md": f"ROS Melodic\n{page}",
        "nodes/node.py": "#!/usr/bin/env python\nimport rospy\nimport tensorflow as tf\nsession = tf.Session()\n",
    }
    assert tree(files).python.version == python


@pytest.mark.parametrize(("distro", "python"), [("Melodic", "python2"), ("Noetic", "python3")])
def test_a_program_beside_nodes_runs_with_their_python(tree: Tree, distro: str, python: str) -> None:
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "scripts/run.py": "#!/usr/bin/env python\nimport rospy\nrospy.init_node('a')\n",
        "README.md": f"ROS {distro}\n```\npython scripts/run.py --go\n```\n",
    }
    assert tree(files).command == (python, "scripts/run.py", "--go")


MODULE = "lib/arm.cpython-38-x86_64-linux-gnu.so"


@pytest.mark.parametrize(
    ("files", "python"),
    [
        ({MODULE: ""}, "3.8"),
        ({MODULE: "", MODULE.replace("38", "39"): ""}, "3.10"),  # of each its own
        ({MODULE.replace("-linux-gnu", "").replace("x86_64", "darwin"): ""}, "3.10"),
        ({f"third_party/{MODULE}": ""}, "3.10"),
        ({MODULE: "", "setup.py": "from setuptools import setup\nsetup(name='a', python_requires='>=3.9')\n"}, "3.10"),
    ],
)
def test_what_is_compiled_for_one_python(tree: Tree, files: dict[str, str], python: str) -> None:
    assert tree({"a.py": "import arm\n", "requirements.txt": "numpy\n", **files}).python.version == python
