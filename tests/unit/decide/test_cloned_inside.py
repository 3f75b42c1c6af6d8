"""What a page or a script clones into the tree, and CMake names there, is there when CMake looks for it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(a)\n{}\nadd_executable(a a.cpp)\n"
CLONE = "cd libs\ngit clone -b v2 https://github.com/lab/tinymesh.git\n"
COMPILED = f"{CLONE}cd tinymesh\nmkdir build && cd build\ncmake -DGUI=OFF ..\nmake\n"
FOLDER = "${PROJECT_SOURCE_DIR}/libs/tinymesh"


def page(text: str) -> str:
    return f"# A\n```\n{text}```\n"


@pytest.mark.parametrize(
    ("line", "path"),
    [
        ("add_subdirectory(libs/tinymesh)", "libs/tinymesh"),
        ("add_subdirectory(tinymesh)", "tinymesh"),
        (f"include_directories({FOLDER}/include)", "libs/tinymesh"),
        (f"set(LIBS {FOLDER})\ninclude_directories(${{LIBS}}/include)", "libs/tinymesh"),
        (f"target_include_directories(a PUBLIC {FOLDER}/include)", "libs/tinymesh"),
        ("include_directories(${CMAKE_CURRENT_LIST_DIR}/libs/tinymesh/include)", "libs/tinymesh"),
        ("include_directories(${a_SOURCE_DIR}/libs/tinymesh/include)", "libs/tinymesh"),
        ("include(libs/tinymesh/cmake/all.cmake)", "libs/tinymesh"),
        ("file(GLOB MESH libs/tinymesh/src/*.cpp)\nadd_library(m ${MESH})", "libs/tinymesh"),
        ("file(GLOB_RECURSE MESH ${CMAKE_SOURCE_DIR}/libs/tinymesh/*.cpp)", "libs/tinymesh"),
        (f"target_sources(a PRIVATE {FOLDER}/mesh.cpp)", "libs/tinymesh"),
    ],
)
def test_a_folder_that_cmake_names_is_cloned(tree: Tree, line: str, path: str) -> None:
    decision = tree({"CMakeLists.txt": CMAKE.format(line), "README.md": page(CLONE)})
    found = [(source.name, source.repo, source.ref) for source in decision.submodules]
    assert found == [(path, "https://github.com/lab/tinymesh.git", "v2")]
    assert decision.inside == ()  # CMake adds it, or has its headers from there


@pytest.mark.parametrize(
    ("clone", "step", "ref"),
    [
        ("git clone https://github.com/lab/tinymesh", "git reset --hard 3f26a07", "3f26a07"),
        ("git clone https://github.com/lab/tinymesh", "git checkout 3f26a07", "3f26a07"),
        ("git clone https://github.com/lab/tinymesh", "git checkout main", None),
        ("git clone https://github.com/lab/tinymesh -b v2", "git reset --hard 3f26a07", "v2"),
        ("git clone https://github.com/ann/tinymesh", "git reset --hard 3f26a07", None),
    ],
)
def test_the_commit_that_ci_takes_of_the_same_repository(tree: Tree, clone: str, step: str, ref: str | None) -> None:
    run = f"git clone https://github.com/lab/tinymesh.git\n          cd tinymesh\n          {step}\n"
    ci = f"jobs:\n  a:\n    steps:\n      - run: |\n          {run}"
    cmake = CMAKE.format("add_subdirectory(libs/tinymesh)")
    files = {"CMakeLists.txt": cmake, "README.md": page(f"cd libs\n{clone}\n"), ".github/workflows/a.yml": ci}
    assert [source.ref for source in tree(files).submodules] == [ref]


def test_the_repository_is_not_cloned_into_itself(tree: Tree) -> None:
    origin = {".git/config": '[remote "origin"]\n\turl = https://github.com/lab/tinymesh.git\n'}
    files = {"CMakeLists.txt": CMAKE.format("include_directories(tinymesh/include)"), "README.md": page(CLONE)}
    assert tree({**files, **origin}).submodules == ()


FORK = "git clone https://github.com/lab/mesh-fork"


@pytest.mark.parametrize("clone", [f"{FORK} libs/tinymesh", f"cd libs/tinymesh\n{FORK} ."])
def test_a_clone_into_a_folder_of_another_name_lies_there(tree: Tree, clone: str) -> None:
    cmake = CMAKE.format("add_subdirectory(libs/tinymesh)")
    decision = tree({"CMakeLists.txt": cmake, "README.md": page(f"{clone}\n")})
    assert [(each.name, each.repo) for each in decision.submodules] == [
        ("libs/tinymesh", "https://github.com/lab/mesh-fork")
    ]


@pytest.mark.parametrize(
    ("line", "more"),
    [
        ("target_link_libraries(a tinymesh)", {}),  # a library by its name
        ("link_libraries(tinymesh)", {}),
        ("include(tinymesh)", {}),  # a module
        ("include_directories(${other_SOURCE_DIR}/libs/tinymesh)", {}),  # of another project
        ("file(DOWNLOAD https://a.b/c libs/tinymesh/a.h)", {}),
        ("include_directories(${PROJECT_SOURCE_DIR}/../../tinymesh)", {}),  # outside of the home folder
        ("include_directories(/opt/tinymesh)", {}),
        ("add_subdirectory(libs/tinymesh)", {"libs/tinymesh/CMakeLists.txt": "project(tinymesh)\n"}),  # there
        ("add_subdirectory(libs/tinymeshes)", {}),  # another name
    ],
)
def test_what_is_no_folder_of_it_is_not(tree: Tree, line: str, more: dict[str, str]) -> None:
    assert tree({"CMakeLists.txt": CMAKE.format(line), "README.md": page(CLONE), **more}).submodules == ()


BESIDE = {
    "${PROJECT_SOURCE_DIR}/../tinymesh": "../tinymesh",
    "../tinymesh": "../tinymesh",
    "$ENV{HOME}/libs/tinymesh": "../libs/tinymesh",
    "~/libs/tinymesh": "../libs/tinymesh",
}


@pytest.mark.parametrize(("written", "place"), BESIDE.items())
def test_one_beside_the_tree_or_in_the_home_folder(tree: Tree, written: str, place: str) -> None:
    line = f"include_directories({written}/include)\nlink_directories({written}/build)"
    decision = tree({"CMakeLists.txt": CMAKE.format(line), "README.md": page(COMPILED)})
    assert [source.name for source in decision.submodules] == [place]
    assert decision.inside == ((place, "-DGUI=OFF"),)
    assert not [source for source in decision.source if source.name == "tinymesh"]


def test_a_workspace_has_others_beside_it(tree: Tree) -> None:
    cmake = "project(a)\nfind_package(catkin REQUIRED)\ninclude_directories(../tinymesh/include)\n"
    manifest = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
    decision = tree({"CMakeLists.txt": cmake, "package.xml": manifest, "README.md": page(CLONE)})
    assert decision.submodules == ()


def test_a_package_takes_it_from_its_own_folder(tree: Tree) -> None:
    files = {
        "robot/package.xml": "<package><name>robot</name><buildtool_depend>catkin</buildtool_depend></package>",
        "robot/CMakeLists.txt": f"project(robot)\nfind_package(catkin REQUIRED)\ninclude_directories({FOLDER})\n",
        "README.md": page(CLONE),
    }
    assert [source.name for source in tree(files).submodules] == ["robot/libs/tinymesh"]


@pytest.mark.parametrize("script", [True, False])
def test_what_is_compiled_there_is_compiled_there(tree: Tree, script: bool) -> None:
    line = f"include_directories({FOLDER}/include)\nlink_directories({FOLDER}/build)"
    files = {"CMakeLists.txt": CMAKE.format(line), "README.md": page(COMPILED)}
    if script:
        files |= {"README.md": page("./install_deps.sh\n"), "install_deps.sh": f"#!/bin/bash\n{COMPILED}"}
    decision = tree(files)
    assert [source.name for source in decision.submodules] == ["libs/tinymesh"]
    assert decision.inside == (("libs/tinymesh", "-DGUI=OFF"),)
