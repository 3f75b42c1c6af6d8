"""Code of papers that is no ROS: what small trees in its manner come to, from the files to the decision."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.knowledge.never import never
from roslab.repository import Repository

MAIN = 'import torch\n\nif __name__ == "__main__":\n    pass\n'


def decided(tmp_path: Path, files: dict[str, str]) -> Decision:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return decide(gather(Repository.open(tmp_path)), Config(), folder_name="paper")


def test_a_camera_has_a_focal_length_and_ubuntu_a_release(tmp_path: Path) -> None:
    cmake = {"CMakeLists.txt": "project(slam)\n"}
    assert decided(tmp_path, {**cmake, "README.md": "`fx` is the focal length\n"}).ubuntu == "jammy"
    assert decided(tmp_path, {**cmake, "README.md": "Tested on focal.\n"}).ubuntu == "focal"


def test_a_small_driver_beside_a_python_program_makes_no_cpp_project(tmp_path: Path) -> None:
    files = {
        "main.py": MAIN,
        "robot.py": "import numpy\n",
        "utils.py": "import cv2\n",
        "camera/CMakeLists.txt": "project(camera)\nadd_executable(camera camera.cpp)\n",
        "camera/camera.cpp": "#include <librealsense2/rs.hpp>\n",
    }
    assert decided(tmp_path, files).kind == "cuda"


def test_cmake_that_requires_cuda_for_sources_of_its_own_is_cuda(tmp_path: Path) -> None:
    cmake = {"CMakeLists.txt": "project(fusion)\nfind_package(CUDA REQUIRED)\n"}
    assert decided(tmp_path, cmake).kind == "cpp"
    assert decided(tmp_path, {**cmake, "src/reduce.cu": ""}).kind == "cuda"


def test_an_examples_requirements_choose_no_cuda(tmp_path: Path) -> None:
    files = {"main.py": MAIN, "requirements.txt": "torch==2.7.1\n"}
    decision = decided(tmp_path, {**files, "examples/old/requirements.txt": "torch==1.11.0+cu113\n"})
    assert decision.cuda == "12.6"


def test_the_authors_own_image_has_its_own_cuda(tmp_path: Path) -> None:
    files = {"main.py": MAIN, "requirements.txt": "torch==1.11.0+cu113\n"}
    assert decided(tmp_path, files).cuda == "11.3"
    decision = decided(tmp_path, {**files, "Dockerfile": "FROM nvidia/cuda:12.2.2-runtime-ubuntu22.04\nCOPY . /app\n"})
    assert (decision.dockerfile, decision.cuda) == ("Dockerfile", "12.2")
    assert next(r for r in decision.reasons if r.question == "cuda").reason.endswith(
        "nvidia/cuda:12.2.2-runtime-ubuntu22.04"
    )


RECIPE = "FROM {}\nCOPY . /app\n"


@pytest.mark.parametrize(
    ("bases", "best"),
    [
        ({"Dockerfile.ubuntu20": "ubuntu:20.04", "Dockerfile.ubuntu24": "ubuntu:24.04"}, "Dockerfile.ubuntu24"),
        ({"Dockerfile.cuda": "nvidia/cuda:11.8.0-devel-ubuntu22.04", "Dockerfile.x": "ubuntu:22.04"}, "Dockerfile.x"),
        ({"docker/a/b/Dockerfile": "ubuntu:22.04", "Dockerfile.desktop": "ubuntu:22.04"}, "Dockerfile.desktop"),
        ({"docker/Dockerfile.a": "lab/slam:latest", "docker/Dockerfile.u": "ubuntu:22.04"}, "docker/Dockerfile.u"),
        ({"docker/Dockerfile": "ubuntu:22.04", "Dockerfile.dev2": "ubuntu:22.04"}, "docker/Dockerfile"),
    ],
)  # fmt: skip
def test_of_several_recipes_the_one_for_everybody(tmp_path: Path, bases: dict[str, str], best: str) -> None:
    files = {"CMakeLists.txt": "project(slam)\n"} | {name: RECIPE.format(base) for name, base in bases.items()}
    assert decided(tmp_path, files).dockerfile == best


def test_what_is_struck_through_is_installed_no_more(tmp_path: Path) -> None:
    readme = "* ~~PyTorch 0.3:~~\n  ~~```\n  pip install torch==0.3.1\n  ```~~\n* 1.0+:\n```\npip install torch\n```\n"
    assert decided(tmp_path, {"main.py": MAIN, "README.md": readme}).pip == ("torch",)


def test_a_python_that_the_pinned_opencv_has_a_wheel_for(tmp_path: Path) -> None:
    decision = decided(tmp_path, {"main.py": MAIN, "requirements.txt": "torch>=1.1\nopencv-python==4.1.2.30\n"})
    assert decision.python.version == "3.8"


@pytest.mark.parametrize(
    ("readme", "command"),
    [
        ("python demo.py --images=<path to images>\n", ("bash",)),
        ("python demo.py --run yyy-yy\n", ("bash",)),
        ("python demo.py\n", ("python", "demo.py")),
        ("python demo.py\npython plot.py\n", ("bash",)),  # plot.py is no less a program for having no guard
        ("python tests/a_test.py\n", ("bash",)),
    ],
)
def test_what_the_readme_runs(tmp_path: Path, readme: str, command: tuple[str, ...]) -> None:
    files = {"demo.py": MAIN, "eval.py": MAIN, "tests/a_test.py": MAIN, "plot.py": "import numpy\n"}
    files["requirements.txt"] = "torch\n"
    assert decided(tmp_path, {**files, "README.md": f"```\n{readme}```\n"}).command == command


def test_a_page_deep_in_the_tree_does_not_say_what_the_whole_runs(tmp_path: Path) -> None:
    files = {"demo.py": MAIN, "data/convert.py": MAIN, "requirements.txt": "torch\n"}
    files["README.md"] = "```\npython demo.py --data my/data\n```\n"
    assert decided(tmp_path, {**files, "data/README.md": "```\npython data/convert.py\n```\n"}).command == ("bash",)


def test_a_compiled_project_is_not_its_helper_script(tmp_path: Path) -> None:
    files = {"CMakeLists.txt": "project(mpc)\nadd_executable(mpc main.cc)\n", "tools/plot.py": MAIN}
    assert decided(tmp_path, {**files, "README.md": "```\npython tools/plot.py\n```\n"}).command == ("bash",)
    assert decided(tmp_path, {**files, "README.md": "Build it.\n"}).command == ("mpc",)


@pytest.mark.parametrize(
    "name", ["nvidia-headless-470", "xserver-xorg-video-nvidia-470", "cuda-compat-11-1", "libnvidia-gl-535"]
)
def test_no_image_holds_the_hosts_driver(name: str) -> None:
    assert never().match(name)
    assert not never().match("libnvidia-container-tools")
    assert not never().match("nvidia-cuda-toolkit")
