"""A CMake project without a package.xml that colcon would build, and that lacks something, is left out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
NODE = {
    "src/node/package.xml": "<package><name>node</name><depend>rclcpp</depend>"
    "<export><build_type>ament_cmake</build_type></export></package>",
    "src/node/CMakeLists.txt": "project(node)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
}
DEMO = (
    "cmake_minimum_required(VERSION 3.8)\nproject(sdk_demo)\nfind_package(AcmeVendorSdk REQUIRED)\n"
    "add_executable(sdk_demo a.cpp)\n"
)
CODE = {"docker/demo/a.cpp": "int main() {}\n"}
STRAY = NODE | CODE | {"docker/demo/CMakeLists.txt": DEMO}


def test_it_is_hidden_and_told(tree: Tree) -> None:
    decision = tree(STRAY)
    assert decision.ignored == ("docker/demo",)
    (told,) = [each for each in decision.warnings if "AcmeVendorSdk" in each.message]
    assert "docker/demo, a project without a package.xml" in told.message
    assert "left out of the build" in told.message
    assert (told.file, told.line) == ("docker/demo/CMakeLists.txt", 3)


@pytest.mark.parametrize(
    "files",
    [
        STRAY | {"docker/demo/CMakeLists.txt": DEMO.replace("AcmeVendorSdk", "PCL")},  # apt has it
        STRAY | {"docker/demo/CMakeLists.txt": DEMO.replace(" REQUIRED", "")},
        STRAY | {"docker/demo/CMakeLists.txt": DEMO.replace("project(sdk_demo)\n", "")},  # colcon takes none of these
        STRAY | {"cmake/FindAcmeVendorSdk.cmake": "set(AcmeVendorSdk_FOUND TRUE)\n"},
        NODE | {"src/node/demo/CMakeLists.txt": DEMO, "src/node/demo/a.cpp": CODE["docker/demo/a.cpp"]},
        NODE | {".docker/CMakeLists.txt": DEMO, ".docker/a.cpp": CODE["docker/demo/a.cpp"]},
        STRAY | {"src/node/CMakeLists.txt": NODE["src/node/CMakeLists.txt"] + "find_package(sdk_demo REQUIRED)\n"},
        STRAY | {"src/node/CMakeLists.txt": NODE["src/node/CMakeLists.txt"] + "find_package(SDK_Demo REQUIRED)\n"},
        STRAY | {"docker/COLCON_IGNORE": ""},
    ],
)
def test_others_are_not_hidden(tree: Tree, files: dict[str, str]) -> None:
    assert tree(files).ignored == ()


def test_a_folder_is_hidden_once(tree: Tree) -> None:
    lacks = DEMO.replace("a.cpp", "lost.cpp")
    assert tree(STRAY | {"docker/demo/CMakeLists.txt": lacks}).ignored == ("docker/demo",)


def test_nothing_is_hidden_where_a_command_of_the_author_may_bring_it(tmp_path: Path, tree: Tree) -> None:
    tree(STRAY)
    (tmp_path / "roslab.yaml").write_text("format: 3\ncustom: make-sdk\n")
    ros = plan_repository(tmp_path).plan.workspace.ros
    assert ros
    assert ros.ignored == ()


def test_catkin_looks_at_no_such_project(tree: Tree) -> None:
    files = {
        "node/package.xml": "<package><name>node</name><buildtool_depend>catkin</buildtool_depend></package>",
        "node/CMakeLists.txt": "project(node)\nfind_package(catkin REQUIRED)\n",
        "demo/CMakeLists.txt": DEMO,
        "demo/a.cpp": "int main() {}\n",
    }
    decision = tree(files)
    assert decision.ignored == ()
    assert not any("AcmeVendorSdk" in each.message for each in decision.warnings)


PCL = STRAY | {"docker/demo/CMakeLists.txt": DEMO.replace("AcmeVendorSdk", "PCL")}


@pytest.mark.parametrize(
    ("files", "found"),
    [
        (PCL, ("docker/demo",)),
        (STRAY, ()),  # it is left out before
        (PCL | {"src/node/CMakeLists.txt": NODE["src/node/CMakeLists.txt"] + "find_package(sdk_demo REQUIRED)\n"}, ()),
        (PCL | {"roslab.yaml": "format: 3\ncommand: build/sdk_demo/sdk_demo\n"}, ()),
        (PCL | {"docker/demo/COLCON_IGNORE": ""}, ()),
    ],
)
def test_one_that_nothing_needs_may_fail(tmp_path: Path, files: dict[str, str], found: tuple[str, ...]) -> None:
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    workspace = plan_repository(tmp_path).plan.workspace
    assert workspace is not None
    assert workspace.may_fail == found
