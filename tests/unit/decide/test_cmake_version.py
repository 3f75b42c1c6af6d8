"""A build that demands a newer CMake than the base has."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.facts import Mention
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository
from trees import tree_of

TOP = "cmake_minimum_required(VERSION {})\nproject(thing)\nadd_executable(thing main.cpp)\n"


def decided(tmp_path: Path, files: dict[str, str]) -> Decision:
    return decide(gather(tree_of(tmp_path, files)), Config(), folder_name="thing")


@pytest.mark.parametrize(
    ("demand", "base"),
    [
        ("3.10", "ubuntu:22.04"),
        ("3.22.1", "ubuntu:22.04"),
        ("3.5...3.28", "ubuntu:22.04"),
        ("3.24 FATAL_ERROR", "ubuntu:24.04"),
        ("4.0", "ubuntu:26.04"),
        ("${LEAST}", "ubuntu:22.04"),
        ("9.0", "ubuntu:22.04"),
    ],
)
def test_the_oldest_ubuntu_that_has_it(tmp_path: Path, demand: str, base: str) -> None:
    assert decided(tmp_path, {"CMakeLists.txt": TOP.format(demand)}).base_image == base


@pytest.mark.parametrize(
    ("demand", "code", "base"),
    [
        ("3.10", "", "ubuntu:18.04"),
        ("3.12", "", "ubuntu:20.04"),
        ("3.12", "#include <opencv/cv.h>\n", "ubuntu:18.04"),
    ],
)
def test_the_oldest_ubuntu_since_the_last_commit_that_has_it(tmp_path: Path, demand: str, code: str, base: str) -> None:
    (tmp_path / "CMakeLists.txt").write_text(TOP.format(demand))
    (tmp_path / "main.cpp").write_text(code)
    date = Mention(topic="date", value="2021-04-14", source="commit", file=".git/HEAD", line=1, text="")
    evidence = replace(gather(Repository.open(tmp_path)), mentions=(date,))
    assert decide(evidence, Config(), folder_name="thing").base_image == base


def test_the_authors_ubuntu_stands_and_cmake_comes_from_pip(tmp_path: Path) -> None:
    files = {"CMakeLists.txt": TOP.format("3.15"), "README.md": "Tested on Ubuntu 18.04.\n"}
    found = decided(tmp_path, files)
    assert found.base_image == "ubuntu:18.04"
    assert [asked.text for asked in found.python.pip_guessed] == ["cmake>=3.15,<4"]
    reason = next(reason for reason in found.reasons if reason.answer == "cmake>=3.15,<4")
    assert (reason.file, reason.line, "newer one" in reason.reason) == ("CMakeLists.txt", 1, True)


def test_examples_tests_and_copies_demand_nothing(tmp_path: Path) -> None:
    aside = {f"{folder}/CMakeLists.txt": TOP.format("3.30") for folder in ("examples", "test", "thirdparty/x")}
    assert decided(tmp_path, {"CMakeLists.txt": TOP.format("3.10"), **aside}).base_image == "ubuntu:22.04"


def test_a_ros_distribution_stands_too(tmp_path: Path) -> None:
    manifest = "<package><name>thing</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {"package.xml": manifest, "CMakeLists.txt": TOP.format("3.20") + "find_package(catkin REQUIRED)\n"}
    found = decided(tmp_path, files)
    assert found.ubuntu == "focal"
    assert [asked.text for asked in found.python.pip_guessed] == ["cmake>=3.20,<4"]


OLD = TOP.format("2.8.12")
BACKEND = '[build-system]\nrequires = ["setuptools", "{}"]\n[project]\nname = "thing"\n'
SETUP = "import subprocess\nfrom setuptools import setup\nsubprocess.run(['cmake', '.'])\nsetup(name='thing')\n"


@pytest.mark.parametrize(
    ("files", "least"),
    [
        ({"CMakeLists.txt": TOP.format("4.0"), "thirdparty/x/CMakeLists.txt": OLD}, "3.5"),
        ({"CMakeLists.txt": TOP.format("4.0"), "thirdparty/x/CMakeLists.txt": TOP.format("3.5")}, None),
        ({"CMakeLists.txt": TOP.format("4.0"), "thirdparty/x/examples/CMakeLists.txt": OLD}, None),
        ({"CMakeLists.txt": OLD}, None),
        ({"CMakeLists.txt": OLD, "setup.py": SETUP, "pyproject.toml": BACKEND.format("cmake>=3.10")}, "3.5"),
        ({"CMakeLists.txt": OLD, "setup.py": SETUP, "pyproject.toml": BACKEND.format("cmake<4")}, None),
        (
            {
                "CMakeLists.txt": OLD,
                "thirdparty/x/setup.py": SETUP,
                "thirdparty/x/pyproject.toml": BACKEND.format("cmake"),
            },
            None,
        ),
        ({"CMakeLists.txt": OLD, "README.md": "```\npip install cmake\n```\n"}, "3.5"),
        (
            {
                "CMakeLists.txt": TOP.format("3.15"),
                "cmake/Download.CMakeLists.cmake.in": "cmake_minimum_required(VERSION 2.8.2)\nproject(${NAME} NONE)\n",
                "pyproject.toml": BACKEND.format("scikit_build_core"),
            },
            "3.5",
        ),
        (
            {
                "CMakeLists.txt": TOP.format("3.15"),
                "thingConfig.cmake.in": "# cmake_minimum_required(VERSION 2.8.2)\n",
                "pyproject.toml": BACKEND.format("scikit_build_core"),
            },
            None,
        ),
        ({"CMakeLists.txt": OLD, "README.md": "```\npip install cmake==3.25.0\n```\n"}, None),
    ],
)
def test_a_cmake_that_refuses_old_code_is_told_to_take_it(
    tmp_path: Path, files: dict[str, str], least: str | None
) -> None:
    found = decided(tmp_path, files)
    assert dict(found.variables).get("CMAKE_POLICY_VERSION_MINIMUM") == least
    reasons = [r for r in found.reasons if r.answer == f"CMAKE_POLICY_VERSION_MINIMUM={least}"]
    assert ["CMakeLists." in (r.file or "") for r in reasons] == ([True] if least else [])


PLAIN = "cmake_minimum_required(VERSION 3.5)\nproject(thing)\n{}\nadd_executable(thing main.cpp)\n"
BIONIC = "Tested on Ubuntu 18.04.\n"


@pytest.mark.parametrize(
    ("body", "asked"),
    [
        ("include(FetchContent)\nFetchContent_MakeAvailable(x)", "cmake>=3.14,<4"),
        ("include(FetchContent)", "cmake>=3.11,<4"),
        ("find_package(Python3 REQUIRED COMPONENTS Interpreter)", "cmake>=3.12,<4"),
        ("find_package(Python3 COMPONENTS Interpreter)", None),
        ("add_link_options(-s)", "cmake>=3.13,<4"),
        ("if(CMAKE_VERSION VERSION_GREATER 3.13)\nadd_link_options(-s)\nendif()", None),
        ("function(f)\nadd_link_options(-s)\nendfunction()", None),
        ("MACRO(FetchContent_MakeAvailable name)\nendmacro()\nFetchContent_MakeAvailable(x)", None),
        ("list(JOIN NAMES , joined)", "cmake>=3.12,<4"),
        ("list(APPEND NAMES JOIN)", None),
        ("set(CMAKE_CXX_STANDARD 17)", None),
        ("target_link_libraries(thing SQLite::SQLite3)", "cmake>=3.14,<4"),
        ("# include(FetchContent)", None),
        ("include(cmake/fetch.cmake)", "cmake>=3.14,<4"),
        ("add_subdirectory(lib)", "cmake>=3.16,<4"),
    ],
)
def test_what_only_later_releases_have_asks_for_them(tmp_path: Path, body: str, asked: str | None) -> None:
    files = {"CMakeLists.txt": PLAIN.format(body), "README.md": BIONIC}
    if "fetch.cmake" in body:
        files["cmake/fetch.cmake"] = "FetchContent_MakeAvailable(x)\n"
    if "(lib)" in body:
        files["lib/CMakeLists.txt"] = "add_library(lib lib.cpp)\ntarget_precompile_headers(lib PRIVATE lib.h)\n"
    found = decided(tmp_path, files)
    assert [each.text for each in found.python.pip_guessed] == ([asked] if asked else [])
    reasons = [reason for reason in found.reasons if reason.answer == asked and asked]
    assert [bool(reason.file and reason.line) for reason in reasons] == ([True] if asked else [])


def test_a_module_of_the_tree_asks_for_no_newer_cmake(tmp_path: Path) -> None:
    files = {"CMakeLists.txt": PLAIN.format("find_package(SQLite3 REQUIRED)"), "README.md": BIONIC}
    assert [each.text for each in decided(tmp_path, files).python.pip_guessed] == ["cmake>=3.14,<4"]
    assert not decided(tmp_path, {**files, "cmake/FindSQLite3.cmake": ""}).python.pip_guessed


def test_a_newer_ubuntu_is_taken_where_none_is_named(tmp_path: Path) -> None:
    found = decided(tmp_path, {"CMakeLists.txt": PLAIN.format("block(SCOPE_FOR VARIABLES)\nendblock()")})
    assert found.base_image == "ubuntu:24.04"
    assert any(reason.reason == "block is called, which needs CMake 3.25" for reason in found.reasons)


MATRIX = "jobs:\n  build:\n    strategy:\n      matrix:\n        os: [{}]\n"
ENDED = "ubuntu-18.04, ubuntu-20.04"


@pytest.mark.parametrize(
    ("systems", "demand", "page", "base"),
    [
        (ENDED, "3.10", "", "ubuntu:18.04"),
        (ENDED, "3.11", "", "ubuntu:20.04"),
        (ENDED, "3.23", "", "ubuntu:18.04"),
        (ENDED, "3.10", "Tested with Python 3.8.\n", "ubuntu:20.04"),
        (f"{ENDED}, ubuntu-22.04", "3.10", "", "ubuntu:22.04"),
        (f"{ENDED}, ubuntu-22.04", "3.10", "Tested with Python 3.8.\n", "ubuntu:20.04"),
        (f"{ENDED}, ubuntu-22.04", "3.11", "Suppose that the Python version is 3.10.\n", "ubuntu:22.04"),
        (f"{ENDED}, ubuntu-22.04, ubuntu-24.04", "3.11", "Tested with Python 3.10.\n", "ubuntu:22.04"),
    ],
)
def test_of_equal_ubuntus_the_one_that_fits_the_pages(
    tmp_path: Path, systems: str, demand: str, page: str, base: str
) -> None:
    ci = MATRIX.format(systems)
    files = {"CMakeLists.txt": TOP.format(demand), "README.md": page, ".github/workflows/build.yml": ci}
    assert decided(tmp_path, files).base_image == base


HIGHER = "cmake_minimum_required(VERSION 3.24)\n"
TREE = {"lib/CMakeLists.txt": "project(lib)\nadd_library(lib lib.cpp)\n", "README.md": "Tested on Ubuntu 22.04.\n"}


@pytest.mark.parametrize(
    ("body", "lib", "asked"),
    [
        (f"option(GPU x ON)\nif(GPU)\n{HIGHER}endif()", "", "cmake>=3.24,<4"),
        (f"option(GPU x OFF)\nif(GPU)\n{HIGHER}endif()", "", None),
        (f"if(WIN32)\n{HIGHER}endif()", "", None),
        ("add_subdirectory(lib)", HIGHER, "cmake>=3.24,<4"),
        ("add_subdirectory(lib)", f"option(GPU x ON)\nif(GPU)\n{HIGHER}endif()\n", "cmake>=3.24,<4"),
        ("option(LIB x ON)\nif(LIB)\nadd_subdirectory(lib)\nendif()", HIGHER, "cmake>=3.24,<4"),
        ("option(LIB x OFF)\nif(LIB)\nadd_subdirectory(lib)\nendif()", HIGHER, None),
        ("if(EXISTS lib/x)\nadd_subdirectory(lib)\nendif()", HIGHER, None),
        ("include(cmake/newer.cmake)", "", "cmake>=3.24,<4"),
        ("option(NEWER x OFF)\nif(NEWER)\ninclude(cmake/newer.cmake)\nendif()", "", None),
    ],
)
def test_the_highest_version_of_all_that_is_read_counts(tmp_path: Path, body: str, lib: str, asked: str | None) -> None:
    files = {**TREE, "CMakeLists.txt": PLAIN.format(body), "cmake/newer.cmake": HIGHER}
    files["lib/CMakeLists.txt"] = lib + files["lib/CMakeLists.txt"]
    found = decided(tmp_path, files)
    assert [each.text for each in found.python.pip_guessed] == ([asked] if asked else [])
    reasons = [reason for reason in found.reasons if reason.answer == asked and asked]
    assert [reason.file for reason in reasons if "lib" in (reason.file or "")] == (
        ["lib/CMakeLists.txt"] if lib and asked else []
    )


def test_a_python_project_that_cmake_compiles_gets_the_newer_cmake_before_it(tmp_path: Path) -> None:
    cmake = f"cmake_minimum_required(VERSION 3.16)\nproject(x CXX)\noption(GPU x ON)\nif(GPU)\n{HIGHER}"
    files = {
        "CMakeLists.txt": f"{cmake}enable_language(CUDA)\nendif()\nadd_library(x SHARED x.cu)\n",
        "x.cu": "#include <cuda_runtime.h>\n",
        "pyproject.toml": BACKEND.format("scikit-build-core") + 'dependencies = ["torch"]\n',
        "README.md": "Tested on Ubuntu 22.04 with CUDA 12.4.\n\n    pip install .\n",
    }
    found = decided(tmp_path, files)
    assert (found.kind, found.python.projects) == ("cuda", (".",))
    assert "cmake>=3.24,<4" in [each.text for each in found.python.pip_guessed]


@pytest.mark.parametrize(
    ("more", "asked"),
    [("", ["3.20"]), ("cmake_minimum_required(VERSION 3.24)\n", ["3.24"]), ("project(altro)\n", [])],
)
def test_what_the_table_of_sources_clones_may_ask_for_it(tmp_path: Path, more: str, asked: list[str]) -> None:
    package = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
    files = {
        "thing/package.xml": package.format("thing", "<depend>altro</depend>"),
        "thing/CMakeLists.txt": f"{more}project(thing)\nfind_package(catkin REQUIRED COMPONENTS altro)\n",
        "README.md": "ROS Noetic\n",
    }
    if "altro" in more:
        files |= {"altro/package.xml": package.format("altro", ""), "altro/CMakeLists.txt": more}
        files["thing/CMakeLists.txt"] = "project(thing)\nfind_package(catkin REQUIRED COMPONENTS altro)\n"
    found = [each.text for each in decided(tmp_path, files).python.pip_guessed]
    assert found == [f"cmake>={version},<4" for version in asked]


@pytest.mark.parametrize(("owner", "asked"), [("shaoyifei96", ["cmake>=3.20,<4"]), ("someone", [])])
def test_another_repository_of_the_name_asks_for_nothing(tmp_path: Path, owner: str, asked: list[str]) -> None:
    package = "<package><name>thing</name><buildtool_depend>catkin</buildtool_depend><depend>altro</depend></package>"
    files = {
        "thing/package.xml": package,
        "thing/CMakeLists.txt": "project(thing)\nfind_package(catkin REQUIRED COMPONENTS altro)\n",
        "README.md": f"ROS Noetic\n\n    cd ~/catkin_ws/src\n    git clone https://github.com/{owner}/altro.git\n",
    }
    found = decided(tmp_path, files)
    assert [source.repo for source in found.source] == [f"https://github.com/{owner}/altro.git"]
    assert [each.text for each in found.python.pip_guessed] == asked
