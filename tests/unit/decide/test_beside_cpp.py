"""An environment of conda or pixi in which C++ is compiled makes it no Python project."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CPP = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(arm)\nadd_executable(arm a.cpp b.cpp)\n",
    "a.cpp": "#include <Eigen/Dense>\nint main() {}\n",
    "b.cpp": "#include <Eigen/Core>\n",
}
ASKS = CPP["CMakeLists.txt"] + "find_package(pinocchio REQUIRED)\n"
TOOLS = "name: a\ndependencies:\n  - cmake\n  - cxx-compiler\n  - eigen\n"
PIXI = "[workspace]\nchannels = ['conda-forge']\nplatforms = ['linux-64']\n[dependencies]\nninja = '*'\neigen = '*'\n"
PYTHON = "numpy", "scipy", "cv2", "yaml"
USED = "name: a\ndependencies:\n  - python=3.9\n  - numpy\n"


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"environment.yml": TOOLS}, "cpp"),
        ({"pixi.toml": PIXI}, "cpp"),
        ({"ci/environment.yml": USED}, "cpp"),
        ({"environment.yml": USED}, "python"),
        ({"environment.yml": f"{USED}  - ceres-solver\n"}, "python"),
        ({"environment.yml": f"{USED}  - pinocchio\n", "CMakeLists.txt": ASKS}, "cpp"),
        ({"environment.yml": TOOLS, "README.md": "```\npython run.py\n```\n", "run.py": "import numpy\n"}, "python"),
        ({"environment.yml": TOOLS, **{f"use_{name}.py": f"import {name}\n" for name in PYTHON}}, "python"),
    ],
)
def test_what_compiles_it_is_no_python(tree: Tree, files: dict[str, str], kind: str) -> None:
    assert tree({**CPP, **files}).kind == kind


@pytest.mark.parametrize(
    ("run", "tool", "command"),
    [
        ("cd build && ./arm data --timer", "cmake", ("arm", "data", "--timer")),
        ("./build/arm data", "cmake", ("arm", "data")),
        ("python export.py", "pip", ("python3", "export.py")),
    ],
)
def test_a_program_that_the_page_starts_is_what_it_is_about(
    tree: Tree, run: str, tool: str, command: tuple[str, ...]
) -> None:
    cmake = "project(arm LANGUAGES CXX CUDA)\nfind_package(CUDA REQUIRED)\nadd_executable(arm a.cpp c.cu)\n"
    files = {**CPP, "CMakeLists.txt": cmake, "c.cu": "__global__ void f() {}\n", "data/one.bin": ""}
    files |= {f"use_{name}.py": f"import {name}\n" for name in PYTHON} | {"export.py": "import onnx\n"}
    build = "git clone https://github.com/lab/nets.git\ncd nets && python3 setup.py develop\ncd ..\n"
    build += "mkdir build && cd build\ncmake .. && make\ncd ..\n"
    page = f"# Arm\n\n```\n{build}```\n\n## Run\n\n```\npython export.py --out model\n```\n\n```\n{run}\n```\n"
    found = tree(files | {"README.md": page})
    assert (found.kind, found.build_tool) == ("cuda", tool)
    assert (found.command == command) == (tool == "cmake")
    assert not (tool == "cmake" and found.scripts)


@pytest.mark.parametrize(
    ("page", "tool"), [("# Build\n`cmake ..`\n", "cmake"), ("# Run\n```\npython plot.py\n```\n", "pip")]
)
def test_a_list_for_scripts_leaves_cuda_to_cmake(tree: Tree, page: str, tool: str) -> None:
    cmake = "project(arm LANGUAGES CXX CUDA)\nfind_package(CUDA REQUIRED)\nadd_executable(arm a.cpp b.cpp c.cu)\n"
    files = {**CPP, "CMakeLists.txt": cmake, "c.cu": "__global__ void f() {}\n"}
    files |= {"README.md": page, "requirements.txt": "numpy\n", "plot.py": "import numpy\n"}
    found = tree(files)
    assert (found.kind, found.build_tool) == ("cuda", tool)
    if tool == "cmake":
        assert found.python.requirements == ("requirements.txt",)


@pytest.mark.parametrize(("folder", "kind"), [("", "cuda"), ("examples/", "cpp")])
def test_tensorrt_is_in_the_images_of_cuda_alone(tree: Tree, folder: str, kind: str) -> None:
    cmake = "project(net)\nfind_package(CUDA REQUIRED)\nadd_executable(net a.cpp b.cpp)\n"
    code = "#include <NvInfer.h>\n#include <NvOnnxParser.h>\n"
    found = tree({**CPP, "CMakeLists.txt": cmake, f"{folder}net.cpp": code, "README.md": "# Needs\n* CUDA==11.6\n"})
    assert found.kind == kind
    assert found.base_image.startswith("nvidia/cuda:11.6" if kind == "cuda" else "ubuntu:")
    packages = {"libnvinfer-dev", "libnvonnxparsers-dev"} if kind == "cuda" else set()
    assert {each for each in found.apt_guessed if each.startswith("libnv")} >= packages


BELOW = {
    "planner/src/CMakeLists.txt": "project(tree)\nadd_executable(tree main.cpp)\n",
    "planner/src/main.cpp": "#include <vector>\nint main() {}\n",
    "planner/helper/show.py": "import matplotlib\nimport numpy\n",
}
STARTED = "import numpy\nif __name__ == '__main__':\n    print(numpy)\n"


@pytest.mark.parametrize(
    ("more", "kind"),
    [
        ({}, "cpp"),
        ({"planner/helper/run.py": STARTED}, "python"),
        ({"README.md": "```\npython planner/helper/show.py\n```\n"}, "python"),
        ({"requirements.txt": "numpy\n"}, "python"),
        ({"planner/helper/net.py": "import torch\n"}, "cuda"),
        ({"README.md": "```\nbash train.sh\n```\n"}, "python"),
        ({"planner/src/CMakeLists.txt": "project(tree)\nadd_library(tree main.cpp)\n"}, "python"),
    ],
)
def test_python_that_is_never_started_serves_the_programs_below(tree: Tree, more: dict[str, str], kind: str) -> None:
    assert tree({**BELOW, **more}).kind == kind


CATKIN = "<package><name>slam_ros</name><buildtool_depend>catkin</buildtool_depend></package>"
EXAMPLE = {
    "Examples/ROS/Slam/package.xml": CATKIN,
    "Examples/ROS/Slam/CMakeLists.txt": "project(slam_ros)\nfind_package(catkin REQUIRED roscpp)\ncatkin_package()\n",
}
BUILD = "# Slam\n```\nmkdir build && cd build\ncmake ..\nmake -j\n```\n"


@pytest.mark.parametrize(
    ("page", "kind"),
    [
        (BUILD, "cpp"),
        (f"{BUILD}Then, for ROS:\n```\ncatkin_make\n```\n", "ros1"),
        ("# Slam\nIt is for ROS.\n", "ros1"),
    ],
)
def test_examples_for_ros_beside_what_the_page_builds_with_cmake_alone(tree: Tree, page: str, kind: str) -> None:
    assert tree({**CPP, **EXAMPLE, "README.md": page}).kind == kind


INSTALLS = "project(walk CXX)\ninclude(cmake/base.cmake)\nADD_REQUIRED_DEPENDENCY(acme)\n{}"


@pytest.mark.parametrize(
    ("more", "kind"),
    [
        ({}, "python"),
        ({"walk/fast.cpp": "#include <Eigen/Core>\n"}, "cpp"),
        ({"CMakeLists.txt": INSTALLS.format("add_library(fast fast.cpp)\n")}, "cpp"),
        ({"CMakeLists.txt": INSTALLS.format("add_subdirectory(src)\n")}, "cpp"),
    ],
)
def test_cmake_that_only_installs_modules_makes_no_cpp(tree: Tree, more: dict[str, str], kind: str) -> None:
    cmake = INSTALLS.format("PYTHON_INSTALL_ON_SITE(walk __main__.py)\n")
    files = {"CMakeLists.txt": cmake, "walk/__init__.py": "", "walk/__main__.py": "import numpy\nprint(numpy)\n"}
    assert tree(files | more).kind == kind
