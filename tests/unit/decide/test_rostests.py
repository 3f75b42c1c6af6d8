"""Which launch files with tests can run in an image whose workspace was built without its tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
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
