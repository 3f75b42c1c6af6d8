"""Code that computes on OpenCV's part for CUDA gets an OpenCV that is compiled with it, or its author is told."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config, Source
from roslab.decide.decision import Decision
from trees import decided

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
USES = '#include <opencv2/opencv.hpp>\n#include "kernel.h"\ncv::cuda::GpuMat left;\nint main() {}\n'
MODULE = f"#include <opencv2/cudaimgproc.hpp>\n{USES}"


def _files(code: str, find: str = "OpenCV 3.4", page: str = "ROS Melodic\n", cuda: str = "CUDA") -> dict[str, str]:
    cmake = f"project(demo)\nfind_package(catkin REQUIRED)\nfind_package({find} REQUIRED)\n"
    cmake += (
        f"find_package({cuda} REQUIRED)\nadd_executable(demo a.cpp)\ntarget_link_libraries(demo ${{OpenCV_LIBS}})\n"
    )
    return {"package.xml": PACKAGE, "CMakeLists.txt": cmake, "a.cpp": code, "README.md": page, "kernel.h": ""}


def _options(decision: Decision) -> list[str]:
    (source,) = [each for each in decision.source if each.name == "opencv"]
    return source.cmake_options.split()


def _told(decision: Decision) -> list[str]:
    return [each.message for each in decision.warnings if "OpenCV compiled with CUDA" in each.message]


def test_its_core_is_compiled_with_cuda(tree: Tree) -> None:
    decision = tree(_files(USES))
    options = _options(decision)
    assert {"-DWITH_CUDA=ON", "-DBUILD_opencv_cudaimgproc=OFF", "-DCUDA_HOST_COMPILER=/usr/bin/g++-6"} <= {*options}
    assert "-DCUDA_ARCH_BIN=6.0,6.1,7.0" in options
    assert "-DWITH_CUDA=OFF" not in options
    (source,) = [each for each in decision.source if each.name == "opencv"]
    assert {"nvidia-cuda-toolkit", "g++-6"} <= {*source.depends}
    assert not source.prepare  # OpenCV 3 has its modules for CUDA itself
    assert not _told(decision)


def test_a_module_that_the_code_includes_is_compiled(tree: Tree) -> None:
    options = _options(tree(_files(MODULE)))
    assert "-DWITH_CUDA=ON" in options
    assert "-DBUILD_opencv_cudacodec=OFF" in options
    assert "-DBUILD_opencv_cudaimgproc=OFF" not in options


def test_the_gpu_that_the_code_is_compiled_for_is_among_its(tree: Tree) -> None:
    files = _files(USES)
    files["CMakeLists.txt"] += "set(CUDA_NVCC_FLAGS ${CUDA_NVCC_FLAGS} --generate-code arch=compute_50,code=sm_50)\n"
    assert "-DCUDA_ARCH_BIN=5.0,6.0,6.1,7.0" in _options(tree(files))


@pytest.mark.parametrize(
    ("code", "moved"),
    [(USES, "mv .apart/modules/cudev modules/"), (MODULE, "mv .apart/modules/cudev .apart/modules/cudaarithm ")],
)
def test_opencv_4_has_its_modules_in_another_repository(tree: Tree, code: str, moved: str) -> None:
    decision = tree(_files(code, find="OpenCV 4.5", page="ROS Noetic\n"))
    (source,) = [each for each in decision.source if each.name == "opencv"]
    assert source.prepare.startswith(f"git clone --quiet --depth 1 --branch {source.ref} https://github.com/opencv/")
    assert moved in source.prepare
    assert "-DWITH_CUDA=ON" in source.cmake_options


@pytest.mark.parametrize(
    ("code", "cuda", "told"),
    [
        (USES.replace("int main() {}", "int main() { return cv::cuda::getCudaEnabledDeviceCount(); }"), "CUDA", False),
        (USES.replace("cv::cuda::GpuMat left;", "#ifdef HAVE_CUDA\ncv::cuda::GpuMat left;\n#endif"), "CUDA", False),
        (USES.replace("cuda::GpuMat", "Mat"), "CUDA", False),
        (USES, "Threads", True),
    ],
    ids=["asks", "conditional", "without", "no CUDA"],
)
def test_nothing_else_is_compiled_with_cuda(tree: Tree, code: str, cuda: str, told: bool) -> None:
    decision = tree(_files(code, cuda=cuda))
    assert "-DWITH_CUDA=ON" not in _options(decision)
    assert len(_told(decision)) == told


def test_the_package_of_an_ubuntu_is_compiled_without_it(tree: Tree) -> None:
    decision = tree(_files(USES, find="OpenCV", page="ROS Noetic\n"))
    assert "libopencv-dev" in decision.apt
    assert len(_told(decision)) == 1


def test_an_opencv_of_roslab_yaml_is_the_authors_matter(tmp_path: Path) -> None:
    own = Source(name="opencv", repo="https://github.com/opencv/opencv", ref="4.2.0")
    files = _files(USES, find="OpenCV", page="ROS Noetic\n")
    assert not _told(decided(tmp_path, files, config=Config(source=(own,))))


@pytest.mark.parametrize(
    ("page", "apt"),
    [("ROS Melodic\n", False), ("ROS Melodic\n```\nsudo apt install libopencv-dev\n```\n", True)],
    ids=["CMake", "page"],
)
def test_a_library_is_not_there_twice_unless_the_author_names_its_package(tree: Tree, page: str, apt: bool) -> None:
    decision = tree(_files(USES, page=page))
    assert ("libopencv-dev" in {*decision.apt, *decision.apt_guessed}) == apt
