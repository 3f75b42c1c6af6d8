"""What a page lists as needed, without a command that installs it."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.prose.limits_in_sentences import bounded
from roslab.evidence.prose.page_lists import blocks, said

ROWS = "| Python | 3.8 |\n| [PyTorch](https://pytorch.org) | 1.9.0 |\n"
TABLE = f"## Requirements\n\n| Package | Version |\n|---|---|\n{ROWS}"
Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("## Requirements\n- PyTorch 0.4.0\n- numpy\n- glob\n- a GPU\n", ["torch==0.4.0", "numpy"]),
        (
            "# Dependencies\n* Python 3.6\n* [SciPy](https://scipy.org)\n* Tensorflow 1.0\n",
            ["scipy", "tensorflow==1.0.*"],
        ),
        ("Required packages:\n\n* OpenCV (>= 3.4)\n* scikit image\n", ["opencv-python>=3.4", "scikit-image"]),
        ("## Prerequisites\n1. PyTorch 1.8 or newer\n2. tqdm, matplotlib\n", ["torch>=1.8", "tqdm", "matplotlib"]),
        (
            "## Setup\n- Known dependencies: Python (3.5.4), OpenAI gym (0.10.5), tensorflow (1.8.0), numpy (1.14.5)\n",
            ["gym==0.10.5", "tensorflow==1.8.0", "numpy==1.14.5"],
        ),
        (
            "## Python dependencies\n- commonroad-io>=2022.1\n- some_package==3\n- `numpy >=1, <2`\n- python>=3.8\n",
            ["commonroad-io>=2022.1", "some_package==3", "numpy>=1,<2"],
        ),
        ("Required Python packages:\n\n* some-package>=2\n\nRequired tools:\n\n* gcc>=7\n", ["some-package>=2"]),
        ("## Requirements\n- cmake>=3.16\n- some-package>=2\n- numpy>=1\n", ["numpy>=1"]),
        ("Requirements: a robot with numpy 1.14\n", []),
        ("## Features\n- Known limits: numpy 1.14\n", []),
        ("It is tested with pytorch-1.0.\n", ["torch==1.0.*"]),
        ("Tested with PyTorch 1.8 / Python 3.6.\n", ["torch==1.8.*"]),
        (
            "Install [Pytorch](https://pytorch.org/). It is required that you have access to a GPU and another tool. "
            "The code is tested with Ubuntu 18.04, Pytorch v1.1, TensorFlow v1.14, CUDA 10.0 and cuDNN v7.4. Note: "
            "after a code update on 2/6/2020, it is now also compatible with Pytorch v1.2+" + " and more" * 20 + "\n",
            ["torch==1.1.*", "tensorflow==1.14.*"],
        ),
        ("Tested with Python 3.8.3, Pytorch 0.7.0/1.6.0, CUDA 10.2.\n", ["torch==1.6.0"]),
        ("Tested with Python 3.8, PyTorch 1.2/1.6, CUDA 10.2.\n", ["torch==1.6.*"]),
        ("Tested with PyTorch 1.13 or 2.0 and CUDA 11.8.\n", ["torch==2.0.*"]),
        ("Tested with PyTorch 1.4/1.6.\n", ["torch==1.4.*"]),
        ("Tested with PyTorch 0.7.0.\n", ["torch"]),
        ("Tested with PyTorch 0.4.1, TensorFlow 1.17 and CUDA 9.0.\n", ["torch==0.4.1", "tensorflow"]),
        ("## Requirements\n- PyTorch 0.8\n- tensorflow>=1.15\n", ["torch", "tensorflow>=1.15"]),
        ("The code requires CARLA 0.9.12 and was tested with gym 0.21.\n", ["carla==0.9.12", "gym==0.21.*"]),
        ("## Requirements\n- numpy arrays are stored in `data`\n- OpenCV must be built with CUDA\n", []),
        ("## Features\n- PyTorch 1.8\n- numpy\n", []),
        ("This does not work with PyTorch 2.0, use another branch.\n", []),
        ("## Requirements\n```\n- numpy\n```\n", []),
        (
            "## Requirements\n\nPython 3.8, PyTorch 1.9.0, OpenCV, NumPy and CUDA 11.1.\n",
            ["torch==1.9.0", "opencv-python", "numpy"],
        ),
        ("## Requirements\n\nPython 3.8, PyTorch 1.9.0 and a robot.\n", []),
        ("## Overview\n\nPyTorch 1.9.0 and NumPy\n", []),
        ("**Dependencies**\n- torch 1.9\n- numpy\n", ["torch==1.9.*", "numpy"]),
        ("**We like**\n- torch 1.9\n", []),
        ("**Dependencies**\n- numpy\n\n**We like**\n- torch 1.9\n", ["numpy"]),
        ("## Dependencies\n**A robot**\n\n- torch 1.9\n", ["torch==1.9.*"]),
        ("The code requires PyTorch (tested with 1.9.0) and numpy.\n", ["torch==1.9.0"]),
        ("## Requirements\n- PyTorch (tested on version 1.9.0)\n", ["torch==1.9.0"]),
        ("We use Python 3.8 and PyTorch 1.9.0 with CUDA 11.1.\n", ["torch==1.9.0"]),
        ("## Setup\nOther packages: numpy, tqdm.\n", []),
        ("## Dependencies\nA GPU. Other packages: numpy, tqdm.\n", ["numpy", "tqdm"]),
        (
            f"{TABLE}| numpy | >=1.20 | arrays |\n| a robot | 1.0 |\n| scipy | newest |\n",
            ["torch==1.9.0", "numpy>=1.20"],
        ),
        ("## Results\n\n| PyTorch | 1.9.0 |\n|---|---|\n", []),
        (
            "# Requirements\n```\npython>=3.6\nnumpy>=1.17\nray>=1.15  % as it\npytorch=1.7\nscipy\ncuda 11.1\n```\n",
            ["numpy>=1.17", "ray>=1.15", "torch==1.7.*", "scipy"],
        ),
        ("### Requirements\n```\nnumpy>=1.17\ngit clone it\n```\n", []),
        ("### Requirements\n```\nnumpy\nscipy\n```\n", []),
    ],
)
def test_what_is_read(text: str, found: list[str]) -> None:
    assert [asked.written for asked in said(text, "README.md")] == found


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (
            "Install the following (with `pip install`):\n\n    plyfile\n    'networkx>=2.2,<2.3'\n\nMore\n",
            ["plyfile", "networkx>=2.2,<2.3"],
        ),
        ("Please install these with pip:\n```\ntqdm\nscipy == 1.4\n```\n    numpy\n", ["tqdm", "scipy==1.4"]),
        ("Install the following with pip:\n\n    pip install numpy\n", []),
        ("Install it with pip:\n\n    tqdm\n    then run it\n", []),
        ("Install everything, with pip:\n\n- tqdm\n", []),
        ("You can install it with pip. The folders:\n\n    data\n", []),
        ("To run it with pip packages:\n\n    demo\n", []),
    ],
)
def test_a_block_that_pip_is_to_be_given(text: str, found: list[str]) -> None:
    assert [asked.written for asked in blocks(text, "README.md")] == found


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("It is important to use `atari-py<=0.2.5` and also `gym <= 0.19.0`.\n", ["atari-py<=0.2.5", "gym<=0.19.0"]),
        ("This needs `numpy==1.19.5`. Enjoy!\n", ["numpy==1.19.5"]),
        ("Do not use `gym<0.20`.\n", []),
        ("If it stops, use `gym<0.20`.\n", []),
        ("There is a bug when using `gym<0.20`.\n", []),
        ("The ROMs of [`atari-py==0.2.5`](https://x.org).\n", []),
        ("You should call `check(gym<0.20)`, then `x<1`-like.\n", ["x<1"]),
        ("```\nuse `gym<0.20`\n```\n", []),
        ("Please use `gym>=0.20`.\n", []),
        (
            "It uses a simulator. Please install iSim==2.2.0 and Stable-baseline3==1.4.0\n",
            ["iSim==2.2.0", "stable-baselines3==1.4.0"],
        ),
        ("Please install gym==0.19.0.\n", ["gym==0.19.0"]),
        ("We had gym==0.19.0 there.\n", []),
        ("To use it, pip install torch==1.9.0\n", []),
        ("Please use torch==1.9.0+cu111 here.\n", []),
        ("Do not use gym==0.19.0.\n", []),
    ],
)
def test_a_limit_in_a_sentence(text: str, found: list[str]) -> None:
    assert [asked.written for asked in bounded(text, "README.md")] == found


@pytest.mark.parametrize(
    ("files", "asked"),
    [
        ({"README.md": "Make sure to use `gym<=0.19.0`.\n```\npip install gym\n```\n"}, ["gym<=0.19.0"]),
        ({"README.md": "Make sure to use `gym<=0.19.0`.\n", "requirements.txt": "gym\n"}, ["gym<=0.19.0"]),
        ({"README.md": "Make sure to use `gym<=0.19.0`.\n", "play.py": "import gym\n"}, ["gym<=0.19.0"]),
        ({"README.md": "Make sure to use `gym<=0.19.0`.\n", "requirements.txt": "gym==0.18\n"}, []),
        ({"README.md": "Make sure to use `attrs<=19`.\n", "requirements.txt": "gym\n"}, []),
    ],
)
def test_a_limit_counts_for_what_something_asks_for(tree: Tree, files: dict[str, str], asked: list[str]) -> None:
    found = tree({"play.py": "import scipy\n", **files}).python
    assert [each.text for each in found.pip_guessed if each.name in {"gym", "attrs"}] == asked


@pytest.mark.parametrize(
    ("said", "version"),
    [
        ("The python version upto `3.7.9` has been reported to work.", "3.7"),
        ("Written for Python **3.8**.", "3.8"),
        ("The Python version is 3.9.", "3.9"),
        ("Python version <= `3.8`", "3.8"),
        ("Python up to 3.8", "3.8"),
        ("Python until 2023", "3.10"),
    ],
)
def test_a_word_or_markup_may_stand_before_the_number(tree: Tree, said: str, version: str) -> None:
    assert tree({"play.py": "import scipy\n", "README.md": f"# Walk\n{said}\n"}).python.version == version


def test_a_list_gives_versions_and_what_nothing_imports(tree: Tree) -> None:
    page = "# Planner\n\n## Requirements\n\n- PyTorch 1.8\n- mujoco-py\n"
    decision = tree({"main.py": "import torch\n", "README.md": page})
    everything = (*decision.python.pip, *decision.python.pip_guessed)
    asked = {each.written: each.line for each in everything if each.file == "README.md"}
    assert asked == {"torch==1.8.*": 5, "mujoco-py": 6}
    needed = [each.written for each in everything if not each.file]  # what mujoco-py must find, ahead of it
    assert "Cython<3" in needed
    assert [each.written for each in decision.python.pip_guessed][: len(needed)] == needed
    assert decision.python.version in {"3.8", "3.9"}


def test_a_list_of_a_compiled_program_installs_nothing(tree: Tree) -> None:
    cmake = "cmake_minimum_required(VERSION 3.5)\nproject(robot CXX)\nadd_executable(robot main.cpp)\n"
    page = "## Dependencies\n\n- OpenCV 3.4\n- protobuf\n"
    decision = tree({"CMakeLists.txt": cmake, "main.cpp": "int main() {}\n", "README.md": page})
    assert decision.python.pip_guessed == ()


@pytest.mark.parametrize(
    "said",
    ["Tested with PyTorch 0.7.0.\n", "```\npip install torch==0.7.0\n```\n", "```\nconda install pytorch=0.7.0\n```\n"],
)
def test_a_release_that_never_was_is_neither_installed_nor_has_wheels(tree: Tree, said: str) -> None:
    decision = tree({"main.py": "import torch\n", "README.md": f"# Walk\n{said}"})
    asked = (*decision.python.pip, *decision.python.pip_guessed, *decision.python.bounds)
    assert "torch" in {each.key for each in asked}
    assert not [each.written for each in asked if "0.7" in each.written]
    assert not [each.reason for each in decision.reasons if "0.7" in each.reason]


def test_a_list_that_pins_a_release_that_never_was_gets_the_python_of_the_one_before(tree: Tree) -> None:
    decision = tree({"main.py": "import torch\n", "requirements.txt": "torch==0.7.0\n"})
    assert decision.python.version == "3.6", "0.4.1 is the newest before it, and has no wheel for 3.8"


def test_a_framework_that_a_page_lists_beside_packages_of_ros(tree: Tree) -> None:
    files = {
        "package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend>{}</package>",
        "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\n",
        "src/net.py": "import torch\nimport numpy\n",
        "README.md": "# A\nFor ROS Noetic.\n## Dependencies:\n1. pytorch 1.9\n2. numpy 1.20\n",
    }
    python = tree(files | {"package.xml": files["package.xml"].format("")}).python
    assert [each.written for each in (*python.pip, *python.pip_guessed) if each.role == "listed"] == ["torch==1.9.*"]


def test_one_that_a_manifest_asks_for(tree: Tree) -> None:
    asked = "<depend>python3-pytorch-pip</depend>"
    files = {
        "package.xml": f"<package><name>a</name><buildtool_depend>catkin</buildtool_depend>{asked}</package>",
        "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\n",
        "src/net.py": "import torch\n",
        "README.md": "# A\nFor ROS Noetic.\n## Dependencies:\n1. pytorch 1.9\n",
    }
    python = tree(files).python
    assert not {each.key for each in (*python.pip, *python.pip_guessed)} & {"torch"}


@pytest.mark.parametrize(
    "line",
    ["|" + " " * 3900 + "x", "a" + " " * 3900 + "b", "```\na" + " " * 20_000 + "b\n```"],
    ids=["a-cell", "a-line", "a-block"],
)
def test_blanks_in_a_list_take_no_time(line: str) -> None:
    start = time.process_time()
    assert not list(said(f"# Requirements\n\n{line}\n", "README.md"))
    assert time.process_time() - start < 1
