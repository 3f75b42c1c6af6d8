"""What a setup.py of ROS leaves out and its programs import is told, with the line that imports it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.python import omitted_packages
from roslab.repository.checkout import Repository

SETUP = """\
from setuptools import find_packages, setup
package_name = 'demo'
setup(
    name=package_name,
    packages=[package_name],
    entry_points={'console_scripts': ['node = demo.node:main', 'other = demo.other:main']},
)
"""
FILES = {
    "src/demo/package.xml": "<package><name>demo</name></package>",
    "src/demo/setup.py": SETUP,
    "src/demo/demo/__init__.py": "",
    "src/demo/demo/node.py": "import rclpy\nfrom demo.parts.arm import Arm\n",
    "src/demo/demo/other.py": "",
    "src/demo/demo/parts/__init__.py": "",
    "src/demo/demo/parts/arm.py": "",
}


def tree(tmp_path: Path, files: dict[str, str]) -> Repository:
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    return Repository.open(tmp_path)


@pytest.mark.parametrize(
    ("files", "places"),
    [
        ({}, ["src/demo/demo/node.py:2"]),
        ({"src/demo/demo/node.py": "import os\nimport demo.parts.arm\n"}, ["src/demo/demo/node.py:2"]),
        ({"src/demo/demo/node.py": "from .parts import arm\n"}, ["src/demo/demo/node.py:1"]),
        ({"src/demo/demo/node.py": "from . import parts\n"}, ["src/demo/demo/node.py:1"]),
        ({"src/demo/demo/node.py": "from demo import other\n", "src/demo/demo/other.py": "from .parts.arm import *\n"},
         ["src/demo/demo/other.py:1"]),
        ({"src/demo/demo/node.py": "def late():\n    import demo.parts\n"}, []),
        ({"src/demo/demo/node.py": "import demo.other\n"}, []),
        ({"src/demo/demo/node.py": "import gone.parts\nfrom .away import thing\n"}, []),
        ({"src/demo/setup.py": SETUP.replace("[package_name]", "find_packages()")}, []),
        ({"src/demo/setup.py": SETUP.replace("[package_name]", "[package_name] + find_packages()")}, []),
        ({"src/demo/setup.py": SETUP.replace("[package_name]", "[package_name, package_name + '.parts']")}, []),
        ({"src/demo/setup.py": SETUP.replace("[package_name]", "['demo', 'demo.parts']")}, []),
        ({"src/demo/setup.py": SETUP.replace("packages=", "package_dir={'': '.'}, packages=")}, []),
    ],
)  # fmt: skip
def test_a_folder_that_is_not_installed(tmp_path: Path, files: dict[str, str], places: list[str]) -> None:
    found = list(omitted_packages.read(tree(tmp_path, {**FILES, **files})))
    assert [each.text for each in found] == places
    assert all((each.value, each.file, each.line) == ("demo.parts", "src/demo/setup.py", 3) for each in found)


def test_what_no_package_of_ros_is_installs_otherwise(tmp_path: Path) -> None:
    files = {path: text for path, text in FILES.items() if not path.endswith("package.xml")}
    assert not list(omitted_packages.read(tree(tmp_path, files)))
