"""What build files clone while they configure or make, with which program, and from which hosts by ``git://``."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import fetching
from trees import tree_of

CLONING = "# git clone it by hand\nExternalProject_Add(sophus GIT_REPOSITORY git://code.example.org/a/sophus.git)\n"
CHECKOUT = (
    "all: installed\nGIT_URL = git://github.com/lab/library.git\ninclude $(shell rospack find mk)/git_checkout.mk\n"
)


def _read(root: Path, files: dict[str, str]) -> fetching.Fetching:
    return fetching.read(tree_of(root, files))


def test_a_makefile_of_rosbuild_clones_with_the_program_of_the_file_that_it_includes(tmp_path: Path) -> None:
    files = {
        "library/Makefile": CHECKOUT,
        "library/manifest.xml": "<package/>",
        "solver/Makefile": "SVN_URL = https://svn.example.org/a\ninclude $(shell rospack find mk)/svn_checkout.mk\n",
        "solver/manifest.xml": "<package/>",
        "arm/Makefile": "include $(shell rospack find mk)/cmake.mk\n# include $(MK)/mk/hg_checkout.mk\n",
        "arm/manifest.xml": "<package/>",
        "docs/Makefile": "include $(shell rospack find mk)/bzr_checkout.mk\n",
    }
    found = _read(tmp_path, files)
    assert {(each.name, each.file, each.line) for each in found.programs} == {
        ("git", "library/Makefile", 3),
        ("ca-certificates", "library/Makefile", 3),
        ("subversion", "solver/Makefile", 2),
    }
    assert found.hosts == ("github.com",)


def test_cmake_clones_with_git_and_copied_code_names_no_hosts(tmp_path: Path) -> None:
    copied = "FetchContent_Declare(x GIT_REPOSITORY git://gitlab.com/b/x.git)\n"
    found = _read(tmp_path, {"cmake/sophus.cmake": CLONING, "third_party/x/CMakeLists.txt": copied})
    assert [(each.name, each.file, each.line) for each in found.programs] == [
        ("ca-certificates", "cmake/sophus.cmake", 2),
        ("git", "cmake/sophus.cmake", 2),
    ]
    assert found.hosts == ("code.example.org",)


@pytest.mark.parametrize(
    ("path", "cloned"),
    [
        ("test/CMakeLists.txt.in", True),
        ("cmake/pybind11.CMakeLists.txt.in", True),
        ("cmake/CMakeLists.gtest.in", True),
        ("cmake/gtest.cmake.in", True),
        ("cmake/gtest.md.in", False),
        ("config.h.in", False),
    ],
)
def test_a_template_of_cmake_clones_like_what_is_made_of_it(tmp_path: Path, path: str, cloned: bool) -> None:
    found = _read(tmp_path, {path: CLONING})
    assert [(each.name, each.file) for each in found.programs] == (
        [("ca-certificates", path), ("git", path)] if cloned else []
    )


def test_nothing_is_cloned(tmp_path: Path) -> None:
    assert (
        _read(tmp_path, {"CMakeLists.txt": "project(a)\n# git clone x\n", "Makefile": CHECKOUT}) == fetching.Fetching()
    )


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("FetchContent_Declare(\n  solvers\n  URL https://github.com/a/b/archive/v1.zip\n)\n", 1),
        ("\nExternalProject_Add(solvers URL https://example.org/b.tar.gz)\n", 2),
        ("file(DOWNLOAD https://example.org/b.cmake ${CMAKE_BINARY_DIR}/b.cmake)\n", 1),
        ("set(AT https://example.org/b.zip)\nFetchContent_Declare(solvers URL ${AT})\n", 2),
        ("FetchContent_Declare(solvers URL ${CMAKE_SOURCE_DIR}/b.zip)  # https://example.org/b.zip\n", 0),
        ("if(WIN32)\n  file(DOWNLOAD https://example.org/b.dll b.dll)\nendif()\n", 0),
        ("set_package_properties(Boost PROPERTIES URL https://boost.org)\n", 0),
        ("project(solvers HOMEPAGE_URL https://example.org)\n", 0),
    ],
)
def test_what_downloads_by_https_needs_certificates_alone(tmp_path: Path, text: str, line: int) -> None:
    found = _read(tmp_path, {"CMakeLists.txt": text}).programs
    assert [(each.name, each.line) for each in found] == ([("ca-certificates", line)] if line else [])
