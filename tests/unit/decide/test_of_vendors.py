"""TensorRT is in NVIDIA's own source of packages: it is added, and the build goes on where it has none."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.knowledge.apt_sources import added_sources
from roslab.pipeline import plan_repository
from trees import tree_of

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
    (told,) = (each for each in decision.warnings if each.message.startswith("libnvinfer-dev is only in its vendor's"))
    assert told.file in FILES


def test_ubuntu_18_04_has_a_source_too(tree: Tree) -> None:
    decision = tree({**FILES, "README.md": "# Demo\nROS Melodic, Ubuntu 18.04\n"})
    assert "libnvinfer-dev" in decision.apt_guessed
    assert any("/cuda/repos/ubuntu1804/x86_64/ /" in each for each in decision.repositories)


def test_what_the_author_lists_has_to_install(tmp_path: Path) -> None:
    tree_of(tmp_path, {**FILES, "roslab.yaml": "format: 3\napt: [libnvinfer-dev]\n"})
    plan = plan_repository(tmp_path).plan
    assert "libnvinfer-dev" in plan.apt
    assert "libnvinfer-dev" not in plan.apt_guessed
    assert not [each for each in plan.warnings if "libnvinfer-dev" in each.message]


@pytest.mark.parametrize(
    ("image", "added"),
    [
        ("nvcr.io/nvidia/cuda:12.2.0-devel-ubuntu22.04", False),
        ("nvidia/cuda:12.2.0-devel-ubuntu22.04", False),
        ("docker.io/nvidia/cuda:12.2.0-devel-ubuntu22.04", False),
        ("dustynv/ros:humble-desktop-l4t-r36.2.0", False),
        ("ros:humble-ros-base", True),
        ("somebody/nvidia:22.04", True),
    ],
)
def test_images_of_the_vendor_have_the_source(image: str, *, added: bool) -> None:
    found = [each for each in added_sources() if "nvidia" in each.url and not each.base.fullmatch(image)]
    assert bool(found) == added


OTHER = "<package><name>other</name><buildtool_depend>catkin</buildtool_depend><depend>demo</depend></package>"
PLAIN = "project(other)\nfind_package(catkin REQUIRED)\nadd_executable(b b.cpp)\n"
BELOW = {f"scan/{name}": text for name, text in FILES.items()}


@pytest.mark.parametrize(
    ("page", "more", "told"),
    [
        ("ROS Noetic", {}, "if that does not install, catkin_make stops at demo, which links it"),
        (
            "ROS Noetic",
            {"other/package.xml": OTHER, "other/CMakeLists.txt": PLAIN},
            "if that does not install, catkin_make stops at demo, which links it, and other needs that",
        ),
        ("ROS Kinetic", {}, "and none of those is known for Ubuntu xenial, so that catkin_make stops at demo, which"),
        ("ROS Melodic", {}, "if that does not install, catkin_make stops at demo, which links it"),
        (
            "ROS Noetic",
            {
                f"{name}/{file}": text.replace("demo", name).replace("nvinfer", "pthread").replace("NvInfer.h", "a.h")
                for name in ("p1", "p2", "p3", "p4", "p5", "p6")
                for file, text in FILES.items()
            },
            "if that does not install, what links it is not built",  # it may be left out of so many
        ),
    ],
)
def test_what_happens_without_it(tree: Tree, page: str, more: dict[str, str], told: str) -> None:
    decision = tree({**BELOW, **more, "README.md": f"# Demo\n{page}\n"})
    (said,) = (each for each in decision.warnings if each.message.startswith("libnvinfer-dev is only in its vendor's"))
    assert told in said.message
