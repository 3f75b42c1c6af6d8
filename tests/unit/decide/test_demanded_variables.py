"""Variables without which a compiled program stops, with a message that says what they are for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from hanging import ends
from roslab.config.model import Config
from roslab.decide.decision import Decision
from trees import decided

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "project(Demo)\nadd_executable(demo demo.cpp)\n"
CODE = '#include <cstdlib>\nint main() {{\n  if (!getenv("{name}")) {{\n    puts("{said}");\n    return 1;\n  }}\n}}\n'


@pytest.mark.parametrize(
    ("name", "said", "value"),
    [
        ("DEMO", "Please set the DEMO environment variable to the root directory of demo.", "./"),
        ("DEMO_ROOT", "DEMO_ROOT must be set to the root of this repository", "./"),
        ("SDK", "Please set the SDK environment variable to the root of the camera's SDK", "told"),
        ("SDK", "SDK needs to be set", "told"),
        ("SDK", "SDK is not set, going on without", ""),
        ("SDK", "Please set OTHER to the root of demo", ""),
    ],
)
def test_a_variable_that_a_program_demands(tree: Tree, name: str, said: str, value: str) -> None:
    found = tree({"CMakeLists.txt": CMAKE, "demo.cpp": CODE.format(name=name, said=said)})
    assert dict(found.variables) == ({name: value} if value == "./" else {})
    told = [each.message for each in found.warnings if "stops without the variable" in each.message]
    assert bool(told) == (value == "told")


def test_what_an_example_demands_is_not_set(tree: Tree) -> None:
    code = CODE.format(name="DEMO", said="Please set DEMO to the root of demo")
    assert tree({"CMakeLists.txt": CMAKE, "examples/demo.cpp": code}).variables == ()


@pytest.mark.parametrize(
    ("condition", "call", "told"),
    [
        ("NOT DEFINED ENV{SDK_DIR}", "FATAL_ERROR", True),
        ("NOT DEFINED ENV{SDK_DIR}", "STATUS", False),
        ("NOT DEFINED ENV{ROS_DISTRO}", "FATAL_ERROR", False),
        ("NOT DEFINED ENV{SDK_DIR} AND WITH_SDK", "FATAL_ERROR", False),
        ("NOT DEFINED SDK_DIR", "FATAL_ERROR", False),
    ],
)
def test_a_variable_that_cmake_demands(tree: Tree, condition: str, call: str, *, told: bool) -> None:
    cmake = f'if({condition})\n  message({call} "SDK_DIR is empty")\nendif()\n'
    found = tree({"CMakeLists.txt": CMAKE + cmake, "demo.cpp": "int main() {}\n"})
    said = [each for each in found.warnings if "CMake stops without the variable SDK_DIR" in each.message]
    assert bool(said) == told
    assert not [each for each in found.warnings if "ROS_DISTRO" in each.message]


BRANCHES = """find_package(sdk QUIET)
if(sdk_FOUND)
  set(LIB sdk::sdk)
elseif(DEFINED ENV{SDK_DIR})
  find_library(LIB sdk HINTS $ENV{SDK_DIR}/lib)
else()
  message(FATAL_ERROR "set SDK_DIR")
endif()
"""


@pytest.mark.parametrize(
    ("files", "value"),
    [
        (("vendor_sdk/sdk/lib/libsdk.so",), "./vendor_sdk/sdk"),
        (("vendor_sdk/sdk/libsdk.so",), None),
        (("a/lib/libsdk.so", "b/lib/libsdk.so"), None),
        ((), None),
    ],
)
def test_a_folder_of_the_tree_that_cmake_demands(tree: Tree, files: tuple[str, ...], value: str | None) -> None:
    package = "<package><name>driver</name><export><build_type>ament_cmake</build_type></export></package>"
    cmake = "project(driver)\nfind_package(ament_cmake REQUIRED)\n" + BRANCHES
    found = tree({"driver/package.xml": package, "driver/CMakeLists.txt": cmake, **dict.fromkeys(files, "x")})
    assert dict(found.variables).get("SDK_DIR") == value


DEFINITION = 'if(NOT DEFINED SDK_KIND)\n  message(FATAL_ERROR "Set SDK_KIND")\nendif()\n'
SAID = "CMake stops without -DSDK_KIND (it says: Set SDK_KIND): give it in `cmake_options` in roslab.yaml"


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({}, True),
        ({"README.md": "```\nmkdir build && cd build\ncmake .. -DSDK_KIND=<which one>\nmake\n```\n"}, True),
        ({"README.md": "```\nmkdir build && cd build\ncmake .. -DSDK_KIND=vendor\nmake\n```\n"}, False),
        ({"CMakePresets.json": '{"configurePresets": [{"cacheVariables": {"SDK_KIND": "a"}}]}'}, False),
        ({"setup.py": "from setuptools import setup\nsetup(name='demo')\n"}, False),
        ({"cmake/sdk.cmake": "IF(NOT SDK_KIND)\n  message(STATUS none)\nENDIF()\n"}, True),
        ({"cmake/sdk.cmake": 'string(TOUPPER "a" SDK_KIND)\n'}, False),
        ({"cmake/sdk.cmake": "find_package(sdk)\n"}, False),
        ({"cmake/sdk.cmake": "pkg_check_modules(SDK REQUIRED sdk)\n"}, False),
        ({"cmake/sdk.cmake": "# set(SDK_KIND a)\n"}, True),
    ],
)
def test_an_option_that_cmake_demands_is_told(tree: Tree, files: dict[str, str], *, told: bool) -> None:
    found = tree({"CMakeLists.txt": CMAKE + DEFINITION, "demo.cpp": "int main() {}\n", **files})
    assert (SAID in [each.message for each in found.warnings]) == told


def test_an_option_that_roslab_yaml_gives_is_not_told(tmp_path: Path) -> None:
    files = {"CMakeLists.txt": CMAKE + DEFINITION, "demo.cpp": "int main() {}\n"}
    found = decided(tmp_path, files, config=Config(cmake_options="-DSDK_KIND=a"))
    assert SAID not in [each.message for each in found.warnings]


def test_many_options_that_cmake_demands_take_no_long_time(tree: Tree) -> None:
    names = [f"SDK_{number}" for number in range(600)]
    demands = "".join(f'if(NOT DEFINED {each})\nmessage(FATAL_ERROR "x")\nendif()\n' for each in names)
    modules = {f"cmake/{number}.cmake": " ".join(names) * 10 for number in range(60)}
    with ends():
        tree({"CMakeLists.txt": CMAKE + demands, "demo.cpp": "int main() {}\n", **modules})


@pytest.mark.parametrize(
    ("condition", "asked"), [("NOT DEFINED SDK_KIND", "-DSDK_KIND"), ("NOT DEFINED ENV{SDK_KIND}", "SDK_KIND")]
)
def test_a_message_of_cmake_is_cited_on_one_line_as_far_as_it_tells(tree: Tree, condition: str, asked: str) -> None:
    said = f'message(FATAL_ERROR "Set SDK_KIND\n   as the page\\nhas it {"long " * 900}")'
    files = {"CMakeLists.txt": f"{CMAKE}if({condition})\n{said}\nendif()\n", "demo.cpp": "int main() {}\n"}
    (message,) = (each.message for each in tree(files).warnings if f" {asked} " in each.message)
    assert "(it says: Set SDK_KIND as the page has it long " in message
    assert len(message) < 400
