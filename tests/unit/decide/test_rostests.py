"""Which launch files with tests can run in an image whose workspace was built without its tests."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.knowledge.test_counts import count_of_tests
from roslab.pipeline import plan_repository
from roslab.plan.found_tests import UNITTEST_SCRIPT
from roslab.plan.proofs import proofs

MANIFEST = (
    '<package format="2"><name>robot</name><version>1.0.0</version><description>x</description>'
    '<maintainer email="a@example.org">a</maintainer><license>MIT</license></package>'
)
CMAKE = "cmake_minimum_required(VERSION 3.0.2)\nproject(robot)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
TREE = {
    "package.xml": MANIFEST,
    "CMakeLists.txt": CMAKE + "add_executable(driver driver.cpp)\nadd_subdirectory(test)\n",
    "test/CMakeLists.txt": "catkin_add_gtest(compiled compiled.cpp)\nadd_executable(helper helper.cpp)\n",
    "test/check.py": "#!/usr/bin/env python3\n",
}
CHECK = '<test test-name="check" pkg="robot" type="check.py"/>'


@pytest.mark.parametrize(
    ("body", "tried"),
    [
        (CHECK, True),
        (f'<node pkg="robot" type="driver" name="d"/>{CHECK}', True),
        (f'<node pkg="rosbag" type="play" name="p"/>{CHECK}', True),
        ('<test test-name="c" pkg="robot" type="compiled"/>', False),
        (f'<node pkg="robot"\n type="helper" name="h"/>{CHECK}', False),
        ('<node pkg="robot" type="check.py" name="d"/>', False),
        (f"<!-- {CHECK} -->", False),
    ],
)
def test_what_is_tried(tmp_path: Path, body: str, tried: bool) -> None:
    for name, text in {**TREE, "test/all.test": f"<launch>{body}</launch>"}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    planned = plan_repository(tmp_path, branch=None)
    found = [proof for proof in planned.plan.proofs if proof.rung == 4]
    assert planned.plan.kind == "ros1"
    assert [proof.command[4:] for proof in found] == ([("test/all.test",)] if tried else [])
    assert not any(proof.required for proof in found)
    assert planned.plan.proofs == proofs(planned.decision, planned.plan.workspace)


PYTHON = {
    "tests/test_arm.py": "def test_arm():\n    assert True\n",
    "tests/test_leg.py": "import unittest\nclass Leg(unittest.TestCase):\n    def test_leg(self):\n        pass\n",
    "tests/test_flake8.py": "from ament_flake8.main import main_with_errors\ndef test_flake8():\n    pass\n",
    "tests/test_node.py": "import rostest\nclass Node:\n    def test_node(self):\n        pass\n",
    "tests/talks_test.py": "import launch_testing\ndef generate_test_description():\n    pass\n",
}


@pytest.mark.parametrize(
    ("files", "names"),
    [
        (PYTHON, ["the repository's launch tests", "the repository's files of Python tests"]),
        ({"tests/test_flake8.py": PYTHON["tests/test_flake8.py"]}, []),
    ],
)
def test_python(tmp_path: Path, files: dict[str, str], names: list[str]) -> None:
    """Those of style, and those that a rostest starts, are no tests of their own."""
    for name, text in {"setup.py": "from setuptools import setup\nsetup(name='robot')\n", **files}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    found = [proof for proof in plan_repository(tmp_path, branch=None).plan.proofs if proof.rung == 4]
    assert [proof.name for proof in found] == names
    assert [proof.command[4:] for proof in found[1:]] == [("tests/test_arm.py", "tests/test_leg.py")][: len(names)]


def test_tests_of_unittest_run_without_pytest(tmp_path: Path) -> None:
    """In folders that are no packages, even one with the name of a module of the standard library."""
    (tmp_path / "test").mkdir()
    (tmp_path / "test/test_leg.py").write_text(PYTHON["tests/test_leg.py"])
    (tmp_path / "pytest.py").write_text("raise ImportError\n")
    answer = subprocess.run(
        ["bash", "-c", UNITTEST_SCRIPT, "proof", "test/test_leg.py"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 0, answer
    assert count_of_tests(answer.stderr) == 1


def test_ctest(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.10)\nproject(arm CXX)\nenable_testing()\nadd_executable(arm arm.cpp)\n"
        "add_test(NAME arm COMMAND arm)\n"
    )
    (tmp_path / "arm.cpp").write_text("int main() {}\n")
    plan = plan_repository(tmp_path, branch=None, folder_name="arm").plan
    assert [(proof.name, proof.command[4:]) for proof in plan.proofs if proof.rung == 4] == [
        ("the repository's tests of CMake", ("arm-build",))
    ]


LISTED = "cmake_minimum_required(VERSION 3.8)\nproject(arm)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"


@pytest.mark.parametrize(
    ("registered", "tried"),
    [
        ("add_launch_test(test/a_test.py)\n# add_launch_test(test/b_test.py)\n", ["test/a_test.py"]),
        ('add_ros_test(\n  "test/b_test.py" TIMEOUT 9)\n', ["test/b_test.py"]),
        ("add_launch_test(${each})\n", ["test/a_test.py", "test/b_test.py"]),
        ("add_test(test/a_test.py)\n", ["test/a_test.py", "test/b_test.py"]),
        ("", ["test/a_test.py", "test/b_test.py"]),
    ],
)
def test_a_launch_test_that_its_package_does_not_register_is_left_out(
    tmp_path: Path, registered: str, tried: list[str]
) -> None:
    """It may be a leftover: the author's own test run does not start it."""
    launched = "import launch_testing\ndef generate_test_description():\n    pass\n"
    manifest = "<buildtool_depend>ament_cmake</buildtool_depend><export><build_type>ament_cmake</build_type></export>"
    xml = (
        f"<package format='3'><name>arm</name><version>1.0.0</version><description>x</description>{manifest}</package>"
    )
    files = {"package.xml": xml, "CMakeLists.txt": LISTED + registered}
    for name, text in {**files, "test/a_test.py": launched, "test/b_test.py": launched}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    found = [proof for proof in plan_repository(tmp_path, branch="jazzy").plan.proofs if proof.rung == 4]
    assert [list(proof.command[4:]) for proof in found] == [tried]
