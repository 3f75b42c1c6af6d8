"""Libraries inside the tree that a page, or a script it runs, compiles there are compiled before the rest."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(a)\nadd_executable(a a.cpp)\n"
SCRIPT = """#!/bin/bash
cd Thirdparty/g2o
mkdir build
cd build
cmake .. -DCMAKE_BUILD_TYPE=Release -DWITH_GUI=OFF
make -j2
cd ../../..
mkdir build
cd build
cmake ..
make -j2
"""
TREE = {"CMakeLists.txt": CMAKE, "Thirdparty/g2o/CMakeLists.txt": "project(g2o)\n", "build.sh": SCRIPT}


def test_a_script_that_the_page_runs(tree: Tree) -> None:
    decision = tree({**TREE, "README.md": "```\nchmod +x build.sh\n./build.sh\n```\n"})
    assert decision.inside == (("Thirdparty/g2o", "-DCMAKE_BUILD_TYPE=Release -DWITH_GUI=OFF"),)


def test_a_script_that_no_page_runs_compiles_nothing(tree: Tree) -> None:
    assert tree({**TREE, "README.md": "Build it with CMake.\n"}).inside == ()


LINKED = "target_link_libraries(a ${PROJECT_SOURCE_DIR}/Thirdparty/g2o/lib/libg2o.so)\n"


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"CMakeLists.txt": CMAKE + LINKED}, (("Thirdparty/g2o", "-DCMAKE_BUILD_TYPE=Release -DWITH_GUI=OFF"),)),
        ({"CMakeLists.txt": CMAKE + LINKED, "build.sh": "make\n"}, (("Thirdparty/g2o", ""),)),
        (
            {"CMakeLists.txt": CMAKE, "b/CMakeLists.txt": f"add_library(b b.cpp)\n{LINKED.replace('}/', '}/../')}"},
            (("Thirdparty/g2o", "-DCMAKE_BUILD_TYPE=Release -DWITH_GUI=OFF"),),
        ),
        ({"CMakeLists.txt": CMAKE + LINKED, "Thirdparty/g2o/lib/libg2o.so": "ELF"}, ()),
        ({"CMakeLists.txt": CMAKE + LINKED + "add_subdirectory(Thirdparty/g2o)\n"}, ()),
    ],
)
def test_a_library_that_is_linked_by_its_file(tree: Tree, files: dict[str, str], found: object) -> None:
    assert tree({**TREE, **files}).inside == found


def test_a_package_of_ros_is_a_library_as_others_where_cmake_alone_builds(tree: Tree) -> None:
    package = "<package><name>g2o</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {**TREE, "CMakeLists.txt": CMAKE + LINKED, "Thirdparty/g2o/package.xml": package}
    assert [folder for folder, _ in tree({**files, "README.md": "Build it with CMake.\n"}).inside] == ["Thirdparty/g2o"]
    own = {"package.xml": package.replace("g2o", "demo"), "CMakeLists.txt": f"find_package(catkin)\n{CMAKE}{LINKED}"}
    assert tree({**files, **own}).inside == ()


def test_a_page_compiles_a_submodule(tree: Tree) -> None:
    modules = '[submodule "third-party/Pangolin"]\n\tpath = third-party/Pangolin\n\turl = https://github.com/s/P.git\n'
    page = "```\ngit clone https://github.com/b/a.git\ncd a/\ncd third-party/OpenNI2/\nmake -j8\ncd ../Pangolin/\n"
    page += "mkdir build\ncd build\ncmake .. -DE=$HOME/a -DPYTHON=OFF\nmake -j8\ncd ../../..\nmkdir build\ncd build\n"
    page += "cmake ..\nmake\n```\n"
    decision = tree({"CMakeLists.txt": CMAKE, ".gitmodules": modules, "README.md": page})
    assert decision.inside == (("third-party/Pangolin", "-DPYTHON=OFF"),)


def test_examples_are_not_compiled_first(tree: Tree) -> None:
    page = "```\ncd examples/one\nmkdir build && cd build\ncmake ..\nmake\n```\n"
    assert tree({"CMakeLists.txt": CMAKE, "examples/one/CMakeLists.txt": CMAKE, "README.md": page}).inside == ()


def test_the_image_compiles_it_before_the_program(tmp_path: Path) -> None:
    for path, text in {**TREE, "README.md": "```\n./build.sh\n```\n"}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert 0 < text.index("Thirdparty/g2o/build") < text.index("# The program")


def test_an_optional_library_that_the_page_builds_by_hand(tree: Tree) -> None:
    cmake = CMAKE.replace("add_executable", "find_package(Pangolin 0.2 QUIET)\nadd_executable")
    page = "```\ngit clone https://github.com/stevenlovegrove/Pangolin.git\ncd Pangolin\nmkdir build\n"
    page += "cd build\ncmake ..\nsudo make install\n```\n"
    assert not tree({"CMakeLists.txt": cmake}).source
    indented = page.replace("```\n", "").replace("\n", "\n\t")
    assert [s.name for s in tree({"CMakeLists.txt": cmake, "README.md": f"Build:\n\n\t{indented}"}).source] == [
        "pangolin"
    ]
    assert [source.name for source in tree({"CMakeLists.txt": cmake, "README.md": page}).source] == ["pangolin"]


def test_a_path_that_begins_in_the_readers_home(tree: Tree) -> None:
    page = "```\ncd ~/ws/src/a/Thirdparty/g2o/\nmkdir build\ncd build\ncmake ..\nmake\n```\n"
    assert tree({**TREE, "README.md": page}).inside == (("Thirdparty/g2o", ""),)


def test_the_ref_of_a_page_wins_over_the_package_of_ros(tree: Tree) -> None:
    package = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
    cmake = "project(a)\nfind_package(catkin REQUIRED)\nfind_package(Sophus REQUIRED)\n"
    page = "ROS melodic\n```\ngit clone https://github.com/strasdat/Sophus.git\ncd Sophus\ngit checkout a621ff\n"
    page += "mkdir build && cd build && cmake ..\nmake\nsudo make install\n```\n"
    decision = tree({"package.xml": package, "CMakeLists.txt": cmake, "README.md": page})
    assert [(source.name, source.ref) for source in decision.source] == [("Sophus", "a621ff")]


def test_a_copied_package_makes_no_workspace_of_a_cmake_project(tree: Tree) -> None:
    package = "<package><name>tag</name><buildtool_depend>catkin</buildtool_depend></package>"
    copied = {"thirdparty/tag/package.xml": package, "thirdparty/tag/CMakeLists.txt": "project(tag)\n"}
    assert tree({"CMakeLists.txt": CMAKE, **copied}).kind == "cpp"


AGENT = "https://github.com/eProsima/Micro-XRCE-DDS-Agent.git"
MODULES = {".gitmodules": f'[submodule "dds"]\n\tpath = px4/DDS\n\turl = {AGENT}\n'}
OF_ROS = {
    "package.xml": "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "project(a)\nfind_package(ament_cmake REQUIRED)\n",
}


LINK = "project(serial)\nadd_library(serial a.cpp)\n"
PLAIN = "<package><name>serial</name><export><build_type>cmake</build_type></export></package>"
CATKIN = "<package><name>serial</name><buildtool_depend>catkin</buildtool_depend></package>"


@pytest.mark.parametrize(
    ("manifest", "last", "found"),
    [
        (PLAIN, "sudo cmake --build . --target install", ("deps/serial",)),
        (PLAIN, "make", ()),
        (CATKIN, "sudo make install", ()),
    ],
)
def test_a_package_of_plain_cmake_that_a_page_installs(
    tree: Tree, manifest: str, last: str, found: tuple[str, ...]
) -> None:
    files = {**OF_ROS, "deps/serial/package.xml": manifest, "deps/serial/CMakeLists.txt": LINK}
    page = f"ROS 2 Humble\n```\ncd deps/serial && mkdir build && cd build\ncmake ..\n{last}\n```\n"
    files[".gitmodules"] = '[submodule "s"]\n\tpath = deps/serial\n\turl = https://github.com/lab/serial.git\n'
    decision = tree({**files, "README.md": page})
    assert tuple(folder for folder, _ in decision.inside) == decision.inside_installed == found


@pytest.mark.parametrize(
    "goes", ["mkdir -p ~/ws/src/a/px4/DDS/build && cd $_", "cd px4/DDS && mkdir build && cd $_", "cd px4/DDS/build"]
)
def test_the_folder_that_is_made_before_it_is_built_in(tree: Tree, goes: str) -> None:
    page = f"ROS 2 Humble\n```\n{goes}\ncmake ..\nsudo cmake --build . --target install\n```\n"
    decision = tree({**OF_ROS, **MODULES, "README.md": page})
    assert (decision.inside, decision.inside_installed) == ((("px4/DDS", ""),), ("px4/DDS",))


@pytest.mark.parametrize(
    ("last", "installed"),
    [
        ("sudo make install\nsudo ldconfig /usr/local/lib/", ("px4/DDS",)),
        ("sudo cmake --install .", ("px4/DDS",)),
        ("", ()),
        ("cd ~/other\nmkdir build && cd build\nsudo make install", ()),
    ],
)
def test_what_a_page_installs_after_it_has_compiled_it(tmp_path: Path, last: str, installed: tuple[str, ...]) -> None:
    before = "ROS 2 Humble\n```\ngit clone https://github.com/lab/a.git\ncd a\n```\nThen\n"
    page = f"{before}```\ncd px4/DDS/ && mkdir build\ncd build\ncmake ..\nmake -j16\n{last}\n```\n"
    for path, text in {**OF_ROS, **MODULES, "README.md": page}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    assert plan.workspace.inside == (("px4/DDS", ""),)
    assert plan.workspace.inside_installed == installed
    text = dockerfile(plan)
    assert ("cmake -P cmake_install.cmake" in text) is bool(installed)
    assert "/CMakeLists.txt ] || { mkdir --parents" in text
    assert "cmake -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF .." in text
    assert "roslab: left out: px4/DDS cannot be compiled" in text
