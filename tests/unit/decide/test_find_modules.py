"""Modules of the tree for packages that CMake requires, and that look for what nothing brings."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hanging import ends
from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
_MANIFEST = (
    "<package format='3'><name>{0}</name><buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend>"
    "<export><build_type>ament_cmake</build_type></export></package>"
)
_CMAKE = """\
project({0})
find_package(ament_cmake REQUIRED)
{1}
add_executable({0}_node node.cpp)
install(TARGETS {0}_node DESTINATION lib/{0})
ament_package()
"""
_MODULE = """\
if (SOLVEX_INCLUDE_DIR)
  set(SOLVEX_FOUND TRUE)
else (SOLVEX_INCLUDE_DIR)
find_path(SOLVEX_INCLUDE_DIR NAMES solvex.h PATHS "$ENV{SOLVEX_HOME}/include")
find_library(SOLVEX_LIBRARY NAMES solvex solvex90 PATHS "$ENV{SOLVEX_HOME}/lib")
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SOLVEX DEFAULT_MSG SOLVEX_LIBRARY SOLVEX_INCLUDE_DIR)
endif (SOLVEX_INCLUDE_DIR)
"""


def _told(
    tree: Tree, *, module: str = _MODULE, asks: str = "find_package(SOLVEX REQUIRED)", builds: str = "colcon build"
) -> tuple[list[str], bool]:
    """Return the warnings about the library, and whether the package may be left out of the build."""
    page = f"ROS 2 Humble\n\n```\n{builds}\nros2 run maps maps_node\n```\n"
    files = {"README.md": page, "planner/FindSOLVEX.cmake": module}
    for name, asked in (("maps", ""), ("planner", asks)):
        files[f"{name}/package.xml"] = _MANIFEST.format(name)
        files[f"{name}/CMakeLists.txt"] = _CMAKE.format(name, asked)
        files[f"{name}/node.cpp"] = "int main() {}\n"
    decision = tree(files)
    return [w.message for w in decision.warnings if "solvex" in w.message], "planner" in decision.may_fail


def test_a_library_that_nothing_brings(tree: Tree) -> None:
    """The build goes on without the package, which the command does not need."""
    told, may_fail = _told(tree)
    said = "CMake links solvex, which find_library looks for and nothing is known to bring: where it does not compile"
    assert [each.partition(";")[0] for each in told] == [f"{said}, planner is left out of the build"]
    assert may_fail


@pytest.mark.parametrize(
    "changed",
    [
        _MODULE.replace("DEFAULT_MSG", "REQUIRED_VARS").replace("_DIR)\nendif", "_DIR VERSION_VAR V)\nendif"),
        _MODULE.replace("else (SOLVEX_INCLUDE_DIR)", "else ()"),
    ],
)
def test_other_spellings_of_the_same(tree: Tree, changed: str) -> None:
    told, may_fail = _told(tree, module=changed)
    assert told
    assert may_fail


@pytest.mark.parametrize(
    ("module", "asks"),
    [
        (_MODULE, "find_package(SOLVEX)"),  # it goes on without
        (_MODULE, "if(WITH_SOLVEX)\nfind_package(SOLVEX REQUIRED)\nendif()"),
        (_MODULE.replace("NAMES solvex solvex90", "NAMES glog solvex"), "find_package(SOLVEX REQUIRED)"),
        (_MODULE.replace("DEFAULT_MSG SOLVEX_LIBRARY", "DEFAULT_MSG"), "find_package(SOLVEX REQUIRED)"),
        (_MODULE.replace("else (SOLVEX_INCLUDE_DIR)", "elseif (WIN32)"), "find_package(SOLVEX REQUIRED)"),
        ("set(SOLVEX_LIBRARIES solvex)\n", "find_package(SOLVEX REQUIRED)"),  # it looks for nothing
    ],
)
def test_what_cmake_goes_on_from(tree: Tree, module: str, asks: str) -> None:
    assert _told(tree, module=module, asks=asks) == ([], False)


def test_gurobi_is_no_part_of_cmake(tree: Tree) -> None:
    """Without a module of the tree CMake has none for it."""
    files = {
        "package.xml": _MANIFEST.format("planner"),
        "CMakeLists.txt": _CMAKE.format("planner", "find_package(GUROBI REQUIRED)"),
        "node.cpp": "int main() {}\n",
    }
    assert any("GUROBI" in each.message for each in tree(files).warnings)


_WAYS = "find_package(OpenBLAS REQUIRED)\nif(Openblas_FOUND)\n  set(A openblas)\n{0}endif()\n"
_OTHER = "else(Openblas_FOUND)\n  find_package(LAPACK REQUIRED)\n"
_WARNS = "find_library(Openblas_LIBRARY libopenblas.so)\nif(NOT Openblas_LIBRARY)\n  message(WARNING none)\nendif()\n"


@pytest.mark.parametrize(
    ("ways", "module", "installed"),
    [
        (_WAYS.format(_OTHER), _WARNS, {"liblapack-dev"}),
        (_WAYS.format(_OTHER), _WARNS.replace("WARNING", "FATAL_ERROR"), {"libopenblas-dev", "liblapack-dev"}),
        (_WAYS.format(_OTHER), "", {"libopenblas-dev", "liblapack-dev"}),
        (_WAYS.format(""), _WARNS, {"libopenblas-dev"}),
        (_WAYS.format("else()\n  set(A none)\n"), _WARNS, {"libopenblas-dev"}),
    ],
)
def test_the_other_way_is_taken_where_the_module_never_stops(
    tree: Tree, ways: str, module: str, installed: set[str]
) -> None:
    files = {"package.xml": _MANIFEST.format("robot"), "CMakeLists.txt": _CMAKE.format("robot", ways)}
    files |= {"node.cpp": "int main() {}\n", **({"cmake/FindOpenBLAS.cmake": module} if module else {})}
    decision = tree(files)
    found = {*decision.apt, *decision.apt_guessed}
    assert {each for each in found if "blas" in each or "lapack" in each} == installed


def test_many_calls_for_such_a_module_end(tree: Tree) -> None:
    """What the file looks for besides is read once, and not for each of them."""
    code = "find_package(OpenBLAS REQUIRED)\n" * 6_000
    with ends():
        tree({"CMakeLists.txt": f"project(a)\n{code}if(NOT A_FOUND)\nendif()\n", "cmake/FindOpenBLAS.cmake": _WARNS})


_HEADERS = """\
find_path(SOLVEX_INCLUDE_DIR NAMES "solvex/solvex.h" PATHS "$ENV{SOLVEX_HOME}" PATH_SUFFIXES include)
foreach(name IN ITEMS solvexa solvexb)
  find_library(FOUND NAMES ${name} PATHS "${SOLVEX_INCLUDE_DIR}/../lib" NO_DEFAULT_PATH)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SOLVEX DEFAULT_MSG SOLVEX_INCLUDE_DIR)
"""


def test_a_header_that_nothing_brings(tree: Tree) -> None:
    told, may_fail = _told(tree, module=_HEADERS)
    said = "CMake looks for the header solvex/solvex.h and stops without it, and nothing is known to bring it"
    assert [each.partition(": ")[0] for each in told] == [said]
    assert may_fail


@pytest.mark.parametrize(
    "changed",
    [
        _HEADERS.replace("solvex/solvex.h", "Eigen/Core"),  # a table knows it
        _HEADERS.replace("solvex/solvex.h", "solvex.h"),  # any library may have it
        _HEADERS.replace("find_path(", "if(WIN32)\nfind_path(").replace("include)", "include)\nendif()", 1),
        _HEADERS.replace("find_package_handle_standard_args", "tell"),
    ],
)
def test_a_header_that_may_be_there(tree: Tree, changed: str) -> None:
    assert _told(tree, module=changed) == ([], False)


@pytest.mark.parametrize("module", [_MODULE, _HEADERS])
def test_a_package_that_the_page_leaves_out_stops_nothing(tree: Tree, module: str) -> None:
    told, may_fail = _told(tree, module=module, builds="colcon build --packages-skip planner")
    assert [each.partition("; ")[0].rpartition(": ")[2] for each in told] == ["planner is left out of the build"]
    assert not may_fail


def test_a_module_is_read_once_for_calls_that_are_alike(tree: Tree) -> None:
    """Each of them asked for all that the module requires."""
    calls = "find_package(Cable REQUIRED)\n" * 3000
    module = "".join(f"find_package(Wire{number} REQUIRED)\n" for number in range(1500))
    files = {"CMakeLists.txt": f"project(demo)\n{calls}add_executable(demo a.cpp)\n", "a.cpp": "int main() {}\n"}
    with ends():
        decision = tree({**files, "cmake/FindCable.cmake": module.replace("Wire7 ", "Boost ")})
    assert "libboost-all-dev" in (*decision.apt, *decision.apt_guessed)
