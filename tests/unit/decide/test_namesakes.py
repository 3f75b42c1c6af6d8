"""A name that the index gives another project stands for the library that the code imports."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = (
    "from setuptools import setup, find_packages\nsetup(name='m', packages=find_packages(), install_requires=[{}])\n"
)


@pytest.mark.parametrize(
    ("asked", "installed", "warned"),
    [("'pinocchio'", "pin", True), ("'pinocchio>=2.6'", "pin>=2.6", True), ("'pin>=2.6'", "", False)],
)
def test_the_library_is_installed(tree: Tree, asked: str, installed: str, warned: bool) -> None:
    found = tree({"setup.py": SETUP.format(asked), "m/__init__.py": "import pinocchio\n"})
    assert [each.written for each in found.python.pip] == ([installed] if installed else [])
    assert not found.python.pip_guessed
    assert any("pinocchio" in each.message for each in found.warnings) is warned


def test_conda_has_it_by_its_name(tree: Tree) -> None:
    environment = "name: x\nchannels: [conda-forge]\ndependencies:\n- python=3.9\n- pinocchio=2.6\n"
    found = tree({"environment.yml": environment, "main.py": "import pinocchio\n"})
    assert (found.python.conda_file, found.python.pip, found.python.pip_guessed) == ("environment.yml", (), ())
    assert not found.warnings


@pytest.mark.parametrize(
    ("asked", "installed"),
    [
        ("pinocchio==2.6.9", "pin>=2.6.9,<3"),
        ("pinocchio==2.6.*", "pin==2.6.*"),
        ("pinocchio~=3.1", "pin~=3.1"),
        ("skimage==0.0", "scikit-image"),
    ],
)
def test_what_is_said_of_its_releases_holds_where_both_have_the_same(tree: Tree, asked: str, installed: str) -> None:
    found = tree({"requirements.txt": f"{asked}\nnumpy\n", "main.py": "import pinocchio\n"})
    assert [each.written for each in found.python.pip] == [installed, "numpy"]


MANIFEST = """<package format="3"><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend>
<{key}>pinocchio</{key}></package>"""


@pytest.mark.parametrize(("key", "installed"), [("depend", ["numpy"]), ("test_depend", ["pin", "numpy"])])
def test_what_a_key_brings_is_not_installed_by_pip_too(tree: Tree, key: str, installed: list[str]) -> None:
    cmake = "project(arm)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    page = "ROS 2 Humble\n```\npip install -r requirements.txt\n```\n"
    files = {"CMakeLists.txt": cmake, "README.md": page, "package.xml": MANIFEST.format(key=key)}
    found = tree({**files, "requirements.txt": "pinocchio\nnumpy\n"})
    assert [each.written for each in found.python.pip] == installed
    assert any("pip cannot install" in each.message for each in found.warnings) is ("pin" in installed)
