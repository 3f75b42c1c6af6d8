"""What a project of CMake adds, over files that add others."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.decide.system.added_projects import added_by
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

MADE = "find_package(GSL)\nadd_library(made made.cpp)\n"
TOP = (
    "project(a)\nadd_executable(a a.cpp)\noption(MORE m OFF)\nadd_subdirectory(b)\n"
    "if(MORE)\nadd_subdirectory(c)\nendif()\nadd_subdirectory(lib/${PART})\n"
)
FILES = {
    "CMakeLists.txt": TOP,
    "b/CMakeLists.txt": f"{MADE}add_subdirectory(part)\n",
    "b/part/CMakeLists.txt": MADE,
    "e/CMakeLists.txt": MADE,
}


@pytest.mark.parametrize(("usual", "more"), [(True, set[str]()), (False, {"c/CMakeLists.txt"})])
def test_what_is_read_and_how_the_rest_begins(tmp_path: Path, more: set[str], *, usual: bool) -> None:
    for path, text in {**FILES, "c/CMakeLists.txt": MADE}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    projects = gather(Repository.open(tmp_path)).cmake
    found = added_by([p for p in projects if p.file == "CMakeLists.txt"], projects, usual=usual)
    assert {p.file for p in found.projects} == {"CMakeLists.txt", "b/CMakeLists.txt", "b/part/CMakeLists.txt", *more}
    assert found.unknown == ("lib/",)
