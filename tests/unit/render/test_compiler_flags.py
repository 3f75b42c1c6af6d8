"""Flags for compilers that roslab.yaml gives, as a repair does: they are there before anything is compiled."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

CPP = {"CMakeLists.txt": "project(robot CXX)\nadd_executable(robot main.cpp)\n"}
COPIES = "#include <string>\nint main() { char a[2]; std::memcpy(a, a, 1); }\n"


@pytest.mark.parametrize(
    ("code", "planned"), [("int main() {}\n", ""), (COPIES, "-include cstring")], ids=["none-planned", "planned"]
)
def test_they_are_set_before_it_is_compiled(tmp_path: Path, code: str, planned: str) -> None:
    tree_of(tmp_path, {**CPP, "main.cpp": code})
    assert f'CXXFLAGS="{planned}"' in dockerfile(plan_repository(tmp_path).plan) or not planned
    tree_of(tmp_path, {"roslab.yaml": "format: 3\nenv: {CXXFLAGS: -include cstring -fpermissive, ROBOT: arm}\n"})
    text = dockerfile(plan_repository(tmp_path).plan)
    before, _, after = text.partition("cmake -DCMAKE_BUILD_TYPE")
    assert 'ENV CXXFLAGS="-include cstring -fpermissive"' in before
    assert "ROBOT=" not in before
    assert "ROBOT=" in after
