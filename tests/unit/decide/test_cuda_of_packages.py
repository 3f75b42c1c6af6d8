"""The CUDA that packages of ROS are compiled with, where Ubuntu's own toolkit is another one."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Base, Config
from roslab.decide.decision import Decision
from trees import decided

MANIFEST = (
    "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><build_depend>roscpp</build_depend></package>"
)
MADE = "cmake_minimum_required(VERSION 3.8)\nproject(demo LANGUAGES CXX CUDA)\nfind_package(catkin REQUIRED)\n"
TOOLKIT = "nvidia-cuda-toolkit"
ARM = 'if(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")\n'


def _decided(root: Path, page: str, cmake: str = MADE, ros: str = "noetic") -> Decision:
    return decided(root, {"package.xml": MANIFEST, "CMakeLists.txt": cmake, "README.md": f"ROS {ros}\n\n{page}\n"})


@pytest.mark.parametrize(
    ("page", "cuda"),
    [
        ("- CUDA (10.2 - 11.5 are tested)", "11.5.2"),
        ("CUDA >= 11.1", "11.8.0"),
        ("CUDA 11.3 or newer", "11.8.0"),
        ("CUDA 11.3", "11.3.1"),
        ("CUDA 12.1", "12.1.1"),
        ("CUDA 10.1", ""),
        ("CUDA 10.0 or higher", ""),
        ("CUDA 9.0", ""),
        ("pip install torch for CUDA 11.3", ""),
        ("A paper.", ""),
    ],
)
def test_the_versions_of_a_page_decide(tmp_path: Path, page: str, cuda: str) -> None:
    found = _decided(tmp_path, page)
    if not cuda:
        assert (found.base_image, TOOLKIT in found.apt) == ("ros:noetic-ros-base", True)
        assert found.platforms == ("linux/amd64",)
        assert found.platforms_refused == (("linux/arm64", f"Ubuntu focal has {TOOLKIT} for amd64 only"),)
    else:
        assert found.base_image == f"nvidia/cuda:{cuda}-devel-ubuntu20.04"
        assert TOOLKIT not in (*found.apt, *found.apt_guessed)
        assert "ros-noetic-ros-base" in found.apt
        assert any("the toolkit of focal is CUDA 10.1" in each.reason for each in found.reasons)
    assert found.gpu


def test_the_toolkit_of_a_newer_ubuntu_is_for_both_platforms(tmp_path: Path) -> None:
    manifest = MANIFEST.replace("catkin", "ament_cmake").replace("roscpp", "rclcpp")
    files = {
        "package.xml": manifest,
        "CMakeLists.txt": MADE.replace("catkin", "ament_cmake") + "ament_package()\n",
        "README.md": "ROS 2 humble, CUDA 11.4 or newer\n",
    }
    found = decided(tmp_path, files)
    assert (found.ros_distro, TOOLKIT in found.apt) == ("humble", True)
    assert found.platforms == ("linux/amd64", "linux/arm64")


@pytest.mark.parametrize(
    ("cmake", "cuda"),
    [
        (f"{MADE}find_package(CUDAToolkit 11.2 REQUIRED)\n", "11.8.0"),
        (f"{MADE}set(CMAKE_CUDA_ARCHITECTURES 86)\n", "11.8.0"),
        (f"{MADE}set(CMAKE_CUDA_ARCHITECTURES 61)\n", ""),
        (MADE.replace(" LANGUAGES CXX CUDA", ""), ""),
    ],
)
def test_what_cmake_asks_for_decides(tmp_path: Path, cmake: str, cuda: str) -> None:
    image = f"nvidia/cuda:{cuda}-devel-ubuntu20.04" if cuda else "ros:noetic-ros-base"
    assert _decided(tmp_path, "", cmake).base_image == image


def test_a_version_without_an_image_is_told(tmp_path: Path) -> None:
    found = _decided(tmp_path, "CUDA 13.0 or newer")
    assert found.base_image == "ros:noetic-ros-base"
    assert any("the toolkit of focal is CUDA 10.1, and no image" in each.message for each in found.warnings)


@pytest.mark.parametrize(
    ("page", "image"),
    [
        ("I am using CUDA 10.2", "nvidia/cuda:11.0.3-devel-ubuntu16.04"),
        ("CUDA 7.5", "ros:kinetic-ros-base"),
        ("A paper.", "ros:kinetic-ros-base"),
    ],
)
def test_the_toolkit_of_xenial_is_an_old_one(tmp_path: Path, page: str, image: str) -> None:
    found = _decided(tmp_path, page, ros="kinetic")
    assert found.base_image == image
    assert (TOOLKIT in found.apt) == (not image.startswith("nvidia"))
    assert found.cuda_options == ()  # what compiles beside it is xenial's own


def test_where_no_image_knows_the_gpus_it_is_told(tmp_path: Path) -> None:
    cmake = f'{MADE}set(CUDA_NVCC_FLAGS "-gencode arch=compute_30,code=sm_30")\n'
    found = _decided(tmp_path, "I am using CUDA 10.2", cmake, ros="kinetic")
    assert found.base_image == "ros:kinetic-ros-base"
    told = [w.message for w in found.warnings if "the toolkit of xenial is CUDA 7.5, and no image" in w.message]
    assert len(told) == 1


@pytest.mark.parametrize(
    ("line", "page", "image", "link"),
    [
        ("set(CUDA_INSTALL_DIR /usr/local/cuda-10.2)", "", "nvidia/cuda:11.0.3-devel-ubuntu16.04", True),
        ("include_directories(/usr/local/cuda-10.2/include)", "", "nvidia/cuda:11.0.3-devel-ubuntu16.04", True),
        ("set(CUDA_INSTALL_DIR /usr/local/cuda-11.1)", "", "nvidia/cuda:11.1.1-devel-ubuntu16.04", False),
        ("set(CUDA_INSTALL_DIR /usr/local/cuda-10.2)", "CUDA 11.1", "nvidia/cuda:11.1.1-devel-ubuntu16.04", True),
        (f"{ARM}set(A /usr/local/cuda-10.2)\nendif()", "", "ros:kinetic-ros-base", False),
        (f"{ARM}else()\nset(A /usr/local/cuda-11.1)\nendif()", "", "nvidia/cuda:11.1.1-devel-ubuntu16.04", False),
        ("if(EXISTS /b)\nset(A /usr/local/cuda-10.2)\nendif()", "", "ros:kinetic-ros-base", False),
        ("set(A_HINTS /opt/a /usr/local/cuda-10.2)", "", "ros:kinetic-ros-base", False),
        ("find_path(A a.h\n  /usr/local/cuda-10.2/include)", "", "ros:kinetic-ros-base", False),
        ("set(A /usr/local/cuda-10.2)\nset(B /usr/local/cuda-11.1)", "", "ros:kinetic-ros-base", False),
        ("# set(CUDA_INSTALL_DIR /usr/local/cuda-10.2)", "", "ros:kinetic-ros-base", False),
        (
            "if(EXISTS /usr/local/cuda-10.2)\nset(CUDA_ARCH 53)\nendif()",
            "",
            "ros:kinetic-ros-base",
            False,
        ),
        (
            "if(EXISTS /usr/local/cuda-10.2)\nset(CUDA_DIR /usr/local/cuda-10.2)\nendif()",
            "",
            "ros:kinetic-ros-base",
            False,
        ),
        ("find_library(A a HINTS /usr/local/cuda-10.2/lib64)", "", "ros:kinetic-ros-base", False),
        (
            "find_path(A a.h\n  PATHS /opt\n  /usr/local/cuda-10.2/include)",
            "",
            "ros:kinetic-ros-base",
            False,
        ),
        ("my_search(A PATHS /usr/local/cuda-10.2)", "", "ros:kinetic-ros-base", False),
        ("if(UNIX)\nset(CUDA_DIR\n  /usr/local/cuda-10.2)\nendif()", "", "nvidia/cuda:11.0.3-devel-ubuntu16.04", True),
        ("set(CUDA_INSTALL_DIR /usr/local/cuda)", "", "ros:kinetic-ros-base", False),
    ],
)
def test_the_toolkit_whose_folder_cmake_names(tmp_path: Path, line: str, page: str, image: str, *, link: bool) -> None:
    found = _decided(tmp_path, page, f"{MADE}{line}\n", ros="kinetic")
    assert found.base_image == image
    assert found.author_folders == ((("/usr/local/cuda-10.2", "/usr/local/cuda"),) if link else ())


@pytest.mark.parametrize(
    ("ros", "base", "image"),
    [
        ("jazzy", "nvidia/cuda:12.1.0-devel-ubuntu22.04", "nvidia/cuda:12.6.3-devel-ubuntu24.04"),
        ("humble", "nvidia/cuda:12.1.0-devel-ubuntu22.04", "nvidia/cuda:12.1.1-devel-ubuntu22.04"),
        ("humble", "nvidia/cuda:11.4.0-devel-ubuntu20.04", "nvidia/cuda:11.7.1-devel-ubuntu22.04"),
        ("noetic", "nvidia/cuda:13.0.0-devel-ubuntu22.04", "nvidia/cuda:12.9.1-devel-ubuntu20.04"),
        ("lyrical", "nvidia/cuda:12.1.0-devel-ubuntu22.04", "ros:lyrical-ros-base"),
    ],
)
def test_ros_is_installed_on_its_own_ubuntu(tmp_path: Path, ros: str, base: str, image: str) -> None:
    """Packages of one Ubuntu cannot be installed on another, whichever CUDA the author's image or a page names."""
    built = MANIFEST if ros == "noetic" else MANIFEST.replace("catkin", "ament_cmake").replace("roscpp", "rclcpp")
    version = base.partition(":")[2].partition("-")[0]
    files = {"package.xml": built, "README.md": f"ROS {ros}, CUDA {version}\n", "docker/Dockerfile": f"FROM {base}\n"}
    found = decided(tmp_path, files)
    assert (found.ros_distro, found.base_image) == (ros, image)
    told = [each.message for each in found.warnings if "has no image for" in each.message]
    assert len(told) == (ros == "lyrical")


@pytest.mark.parametrize(("ros", "image"), [("humble", "11.7.1"), ("lyrical", "none")])
def test_the_image_for_a_version_without_any_is_told_as_it_is(tmp_path: Path, ros: str, image: str) -> None:
    built = MANIFEST.replace("catkin", "ament_cmake").replace("roscpp", "rclcpp")
    base = "FROM nvidia/cuda:10.2-devel-ubuntu18.04\n"
    found = decided(tmp_path, {"package.xml": built, "README.md": f"ROS {ros}\n", "docker/Dockerfile": base})
    (told,) = (each.message for each in found.warnings if "the image has" in each.message)
    assert f"its last patch's too; the image has {image}. A framework" in told


def test_a_version_that_was_asked_for_is_told(tmp_path: Path) -> None:
    manifest = MANIFEST.replace("catkin", "ament_cmake").replace("roscpp", "rclcpp")
    config = Config(base=Base(ros="jazzy", cuda="12.1"))
    found = decided(tmp_path, {"package.xml": manifest}, config=config)
    assert found.base_image == "nvidia/cuda:12.6.3-devel-ubuntu24.04"
    said = "CUDA 12.1 has no image for noble, which ROS jazzy is packaged for: 12.6 is taken"
    assert [each.message.partition(";")[0] for each in found.warnings if "has no image" in each.message] == [said]
