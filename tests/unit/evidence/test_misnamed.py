"""Variables that CMake files use and nothing sets."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import misnamed
from roslab.repository.checkout import Repository

FOUND = "find_package(Eigen3 REQUIRED)\n"
USED = "include_directories(${Eigen3_INCLUDE_DIRS})\n"
MEANT = (("Eigen3_INCLUDE_DIRS", "/usr/include/eigen3"),)


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"CMakeLists.txt": FOUND + USED}, MEANT),
        ({"a/CMakeLists.txt": "find_package( eigen3 )\n" + USED}, MEANT),
        ({"CMakeLists.txt": FOUND + USED.replace("Eigen3", "EIGEN3")}, ()),
        ({"CMakeLists.txt": USED}, ()),
        ({"CMakeLists.txt": FOUND + "set(Eigen3_INCLUDE_DIRS /opt)\n" + USED}, ()),
        ({"CMakeLists.txt": FOUND + USED, "cmake/a.cmake": "find_path( Eigen3_INCLUDE_DIRS Eigen)\n"}, ()),
        ({"third_party/a/CMakeLists.txt": FOUND + USED}, ()),
    ],
)
def test_names_that_the_package_does_not_set(tmp_path: Path, files: dict[str, str], found: object) -> None:
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    assert misnamed.read(Repository.open(tmp_path)) == found
