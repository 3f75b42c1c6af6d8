"""TensorRT is in NVIDIA's own source of packages: it is added, and the build goes on where it has none."""

from __future__ import annotations

from collections.abc import Callable

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(a a.cpp)\ntarget_link_libraries(a nvinfer)\n"
XML = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
FILES = {"package.xml": XML, "CMakeLists.txt": CMAKE, "a.cpp": "#include <NvInfer.h>\nint main() {}\n"}


def test_the_source_is_added_to_an_image_of_ros(tree: Tree) -> None:
    decision = tree({**FILES, "README.md": "# Demo\nROS Noetic, Ubuntu 20.04\n"})
    assert decision.base_image == "ros:noetic-ros-base"
    assert "libnvinfer-dev" not in decision.apt
    assert "libnvinfer-dev" in decision.apt_guessed
    source = "https://developer.download.nvidia.com/compute/cuda/repos/ubuntu2004/x86_64/"
    assert f"deb [signed-by={source}3bf863cc.pub] {source} /" in decision.repositories
    assert any("libnvinfer-dev is in no archive of Ubuntu" in each.message for each in decision.warnings)
