"""Code of ROS 1 that includes what is generated from a message, and does not wait for it."""

from __future__ import annotations

import secrets
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

from lab import doors
from lab.laboratory import Laboratory

WAIT = 20
"""Seconds before the first header is generated, once: the compiler needs it long before, on any machine."""
CMAKE = """\
cmake_minimum_required(VERSION 3.0)
project(late)
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs message_generation)
add_message_files(FILES Level.msg)
generate_messages(DEPENDENCIES std_msgs)
add_custom_target(a_slow_generator COMMAND mkdir waited && sleep {wait} || true)
add_dependencies(${{PROJECT_NAME}}_generate_messages_cpp a_slow_generator)
catkin_package()
include_directories(${{CMAKE_CURRENT_BINARY_DIR}} ${{catkin_INCLUDE_DIRS}})
add_executable(a_node main.cpp)
target_link_libraries(a_node ${{catkin_LIBRARIES}})
"""
MANIFEST = """\
<package format="2">
<name>late</name><version>1.0.0</version><description>d</description><license>MIT</license>
<maintainer email="m@example.org">m</maintainer>
<buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend><depend>std_msgs</depend>
<build_depend>message_generation</build_depend><exec_depend>message_runtime</exec_depend>
</package>
"""
MAIN = """\
// {number}
#include <late/Level.h>
#include <cstdio>
int main() {{ std::puts("it waits"); }}
"""


def test_headers_of_messages_are_generated_first(
    lab: Laboratory, roslab: Callable[..., CompletedProcess[str]], tmp_path: Path
) -> None:
    files = {
        "msg/Level.msg": "float64 value\n",
        "CMakeLists.txt": CMAKE.format(wait=WAIT),
        "package.xml": MANIFEST,
        # A number of this tree alone: a builder that knows the tree already would not compile it again
        "main.cpp": MAIN.format(number=secrets.token_hex(8)),
        "roslab.yaml": "format: 3\nkind: ros1\nbase: {ros: noetic}\ntest: rosrun late a_node\n",
    }
    folder = doors.write(tmp_path / "late", files)
    answer = roslab("build", folder, "--tag", "repro-lab", env=lab.environment, timeout=900)
    assert answer.returncode == 0, answer.stderr[-4000:]
    assert "roslab: what includes late/Level.h does not wait until it is generated" in answer.stderr
    (folder / "main.cpp").write_text("#include <late/NoSuch.h>\n#include <nowhere/Header.h>\nint main() {}\n")
    answer = roslab("build", folder, "--tag", "repro-lab", env=lab.environment, timeout=900)
    assert answer.returncode == 5
    assert "late/NoSuch.h" in answer.stderr
