"""The options with which an author compiles a library of the table, beside those of its row."""

from __future__ import annotations

from collections.abc import Callable

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
DOCKER = """\
FROM ubuntu:22.04
RUN git clone --branch v2.53.1 https://github.com/IntelRealSense/librealsense.git /opt/librealsense && \\
    cd /opt/librealsense && mkdir build && cd build && \\
    cmake ../ -DFORCE_RSUSB_BACKEND=OFF -DBUILD_GRAPHICAL_EXAMPLES=ON -DBUILD_WITH_CUDA=OFF && make && make install
"""
FILES = {
    "CMakeLists.txt": "project(demo)\nfind_package(realsense2 REQUIRED)\nadd_executable(demo demo.cpp)\n",
    "demo.cpp": "int main() {}\n",
}


def test_the_authors_ref_and_options_win(tree: Tree) -> None:
    (built,) = (
        source for source in tree({**FILES, "docker/Dockerfile": DOCKER}).source if source.name == "librealsense"
    )
    assert built.ref == "v2.53.1"
    options = built.cmake_options.split()
    assert {"-DFORCE_RSUSB_BACKEND=OFF", "-DBUILD_WITH_CUDA=OFF", "-DBUILD_GRAPHICAL_EXAMPLES=ON"} <= {*options}
    assert "-DBUILD_EXAMPLES=OFF" in options
    assert len(options) == len({each.partition("=")[0] for each in options})


def test_it_is_built_where_no_ros_has_it(tree: Tree) -> None:
    found = tree(FILES)
    assert [source.name for source in found.source] == ["librealsense"]
    assert not any("realsense" in each.message for each in found.warnings)
