"""The folder of ROS's libraries is told to the linker beside what the base image tells it."""

from __future__ import annotations

from pathlib import Path

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile


def test_the_folders_of_the_base_image_stay(tmp_path: Path) -> None:
    files = {
        "package.xml": "<package><name>map</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
        "CMakeLists.txt": "project(map)\nfind_package(ament_cmake REQUIRED)\nfind_package(g2o REQUIRED)\n"
        "add_executable(a a.cpp)\ntarget_link_libraries(a g2o_core)\nament_package()\n",
        "a.cpp": "int main() {}\n",
        "README.md": "ROS 2 Humble\n",
    }
    for path, text in files.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    made = dockerfile(plan_repository(tmp_path).plan)
    assert '\nENV LIBRARY_PATH="/opt/ros/humble/lib${LIBRARY_PATH:+:${LIBRARY_PATH}}"\n' in made
