"""A library that CMake links by a bare name is told where nothing makes or brings it, and sought as a package is."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
TOP = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\n{}\nadd_executable(demo a.cpp)\n"
LINK = "target_link_libraries(demo acme_line)"
OWNER = {".git/config": '[remote "origin"]\n\turl = https://github.com/lab/demo\n', ".git/HEAD": "ref: refs/heads/a\n"}
FETCHED = "include(FetchContent)\nFetchContent_Declare(words GIT_REPOSITORY https://github.com/me/words.git GIT_TAG v1)"
MODULE = '[submodule "libs/acme"]\n\tpath = libs/acme\n\turl = https://github.com/me/acme.git\n'


def cpp(body: str, **others: str) -> dict[str, str]:
    made = {"CMakeLists.txt": TOP.format("") + body, "a.cpp": "int main() {}\n", "README.md": "Ubuntu 20.04\n"}
    return {**made, **others}


def ros1(body: str, **others: str) -> dict[str, str]:
    found = TOP.format("find_package(catkin REQUIRED)\ncatkin_package()")
    return {**cpp(""), "CMakeLists.txt": found + body, "package.xml": PACKAGE, "README.md": "ROS Noetic\n", **others}


def told(decision: Decision) -> list[tuple[str | None, int | None]]:
    said = "which nothing in the tree makes and nothing is known to bring"
    return [(w.file, w.line) for w in decision.warnings if said in w.message and "links acme_line" in w.message]


@pytest.mark.parametrize("kind", [cpp, ros1])
@pytest.mark.parametrize(
    ("body", "others", "lacks"),
    [
        (LINK, {}, True),
        ("set(LIBS m acme_line)\ntarget_link_libraries(demo ${LIBS})", {}, True),
        ("add_library(acme_line b.cpp)\n" + LINK, {}, False),
        ("own_library(acme_line b.cpp)\n" + LINK, {}, False),
        ("add_subdirectory(lib)\n" + LINK, {"lib/CMakeLists.txt": "add_library(acme_line b.cpp)\n"}, False),
        (LINK, {"lib/libacme_line.so": "\x7fELF"}, False),
        (LINK, {"other/CMakeLists.txt": "project(other)\nadd_library(acme_line b.cpp)\n"}, False),
        ("if(WITH)\n" + LINK + "\nendif()", {}, False),
        ("target_link_libraries(demo ${acme_line})", {}, False),
        ("find_package(acme QUIET)\n" + LINK, {}, False),
        (FETCHED + "\n" + LINK, {}, False),
        (LINK, {".gitmodules": MODULE}, False),
        (LINK, {"README.md": "Tested on Ubuntu 20.04 (ROS Noetic)\n```\nsudo apt install libacme-dev\n```\n"}, False),
        ("", {"lib/CMakeLists.txt": LINK + "\n"}, False),
        ("add_subdirectory(lib)", {"lib/CMakeLists.txt": LINK + "\n"}, True),
    ],
)
def test_a_name_of_which_nothing_tells_is_told(
    tree: Tree, kind: Callable[..., dict[str, str]], body: str, others: dict[str, str], lacks: bool
) -> None:
    decision = tree({**kind(body), **others})
    assert bool(told(decision)) is lacks
    if lacks and not others:
        text = (kind(body))["CMakeLists.txt"]
        line = text.split("target_link_libraries")[0].count("\n") + 1
        assert told(decision) == [("CMakeLists.txt", line)]


@pytest.mark.parametrize(
    "name", ["m", "pthread", "gomp", "swscale", "gpiodcxx", "Xxf86vm", "gtest_main", "boost_system"]
)
def test_libraries_of_the_system_are_none(tree: Tree, name: str) -> None:
    body = f"find_package(Boost REQUIRED)\ntarget_link_libraries(demo {name})"
    assert not any("links" in warning.message for warning in tree(cpp(body)).warnings)


def test_the_owners_repository_of_that_name_is_tried(tree: Tree) -> None:
    decision = tree({**ros1(LINK), **OWNER})
    sought = [(s.repo, s.holding) for s in decision.source]
    assert sought == [("https://github.com/lab/acme_line.git", ("acme_line",))]
    assert len(told(decision)) == 1
    (message,) = [w.message for w in decision.warnings if "links acme_line" in w.message]
    assert "the build looks for it in https://github.com/lab/acme_line" in message


def test_a_library_that_is_exported_too_and_of_which_a_header_is_included_is_tried_and_told_once(tree: Tree) -> None:
    files = {**ros1(LINK), **OWNER, "a.cpp": "#include <acme_line/line.h>\nint main() {}\n"}
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("catkin_package()", "catkin_package(DEPENDS acme_line)")
    decision = tree(files)
    assert [s.holding for s in decision.source] == [("acme_line",)]
    (message,) = [w.message for w in decision.warnings if "acme_line" in w.message]
    assert "the build looks for it in https://github.com/lab/acme_line, and where it is not there" in message


def test_no_workspace_no_search(tree: Tree) -> None:
    decision = tree({**cpp(LINK), **OWNER})
    assert not decision.source
    assert len(told(decision)) == 1


@pytest.mark.parametrize(("header", "lacks"), [("eigen3/acme_line.h", False), ("acme/other.h", True)])
def test_the_package_of_a_header_brings_the_library_of_its_name(tree: Tree, header: str, lacks: bool) -> None:
    files = cpp(LINK) | {"a.cpp": f"#include <{header}>\nint main() {{}}\n"}
    assert bool(told(tree(files))) is lacks


@pytest.mark.parametrize("name", ["cgraph", "gvc", "cdt"])
def test_the_libraries_of_graphviz(tree: Tree, name: str) -> None:
    decision = tree(cpp(LINK.replace("acme_line", name)))
    assert "libgraphviz-dev" in (*decision.apt, *decision.apt_guessed)


@pytest.mark.parametrize(
    ("name", "package"),
    [
        ("lua5.1", "liblua5.1-0-dev"),
        ("lua5.3", "liblua5.3-dev"),
        ("popt", "libpopt-dev"),
        ("tcmalloc", "libgoogle-perftools-dev"),
    ],
)
def test_a_submodule_that_is_not_there_brings_no_library_of_the_system(tree: Tree, name: str, package: str) -> None:
    body = f"set(libs m {name})\ntarget_link_libraries(demo ${{libs}})"
    decision = tree(ros1(body, **{".gitmodules": MODULE}))
    assert package in (*decision.apt, *decision.apt_guessed)


def test_the_module_of_cmake_for_an_old_lua_finds_its_package(tree: Tree) -> None:
    decision = tree(cpp("find_package(Lua51 REQUIRED)\n"))
    assert "liblua5.1-0-dev" in (*decision.apt, *decision.apt_guessed)
    assert not any("Lua51" in warning.message for warning in decision.warnings)


def test_a_lua_of_a_version_is_not_an_older_one(tree: Tree) -> None:
    decision = tree(cpp("find_package(Lua 5.3 REQUIRED)\n"))
    assert [name for name in (*decision.apt, *decision.apt_guessed) if "lua" in name] == ["liblua5.3-dev"]


def test_the_bus_of_a_small_computer_is_a_library_of_the_system(tree: Tree) -> None:
    files = cpp(LINK.replace("acme_line", "i2c"), **{"src/bus.cpp": "#include <i2c/smbus.h>\n"})
    decision = tree(files)
    assert "libi2c-dev" in (*decision.apt, *decision.apt_guessed)
    assert not any("i2c" in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    ("linked", "package"),
    [
        ("boost_system", "libboost-all-dev"),
        ("boost_program_options", "libboost-all-dev"),
        ("PocoNet", "libpoco-dev"),
        ("BulletCollision", "libbullet-dev"),
        ("fftw3f", "libfftw3-dev"),
        ("osgViewer", "libopenscenegraph-dev"),
        ("ncursesw", "libncurses-dev"),
    ],
)
@pytest.mark.parametrize(
    "call", ["target_link_libraries(demo {})", "set(LIBS m {})\ntarget_link_libraries(demo ${{LIBS}})"]
)
def test_what_ubuntu_has_under_the_name_that_is_linked(tree: Tree, linked: str, package: str, call: str) -> None:
    cmake = f"project(demo CXX)\nadd_executable(demo a.cpp)\n{call.format(linked)}\n"
    found = tree({"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n"})
    assert package in found.apt_guessed
    assert f"links {linked}" not in "".join(warning.message for warning in found.warnings)
