"""What no longer answers is named in the plan, each with what replaces it: small trees in the manner of real papers."""

from __future__ import annotations

from pathlib import Path

from roslab.pipeline import plan_repository
from roslab.render.report import inspection_text
from trees import tree_of


def replaced(tmp_path: Path, files: dict[str, str], *, branch: str | None = None) -> dict[str, str]:
    tree_of(tmp_path, files)
    planned = plan_repository(tmp_path, branch=branch)
    said = inspection_text(planned.decision, planned.plan)
    for each in planned.plan.upstreams:
        assert each.why
        assert f"{each.name} → {each.instead}" in said
    return {each.name: each.instead for each in planned.plan.upstreams}


PACKAGE = """<package format="2">
  <name>benchmark</name><version>0.1.0</version><description>x</description>
  <maintainer email="a@example.org">a</maintainer><license>MIT</license>
  <buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend>
</package>
"""


def test_a_network_of_tensorflow_1_and_python_2(tmp_path: Path) -> None:
    files = {
        "README.md": "Tested with python 2.7.\n",
        "requirements.txt": "numpy==1.14.4\ntensorflow-gpu==1.13.1\nflow @ git+git://github.com/someone/flow.git@v1\n",
        "demo.py": "import tensorflow as tf\n\nprint tf.__version__\n",
    }
    found = replaced(tmp_path, files)
    assert "nvidia/cuda:11" in found["image nvidia/cuda of CUDA 10.0"]
    assert found["Python 2.7 of focal"] == "python=2.7 of conda-forge"
    assert found["git://github.com/"] == "https://github.com/"
    assert any("NVIDIA" in name for name in found)
    assert any("archive of focal" in name for name in found)


def test_a_workspace_of_melodic_whose_sister_only_its_readme_names(tmp_path: Path) -> None:
    files = {
        "README.md": "```\ncd ~/catkin_ws/src\ngit clone https://github.com/example/robot_model.git\n```\n",
        "benchmark/package.xml": PACKAGE,
        "benchmark/CMakeLists.txt": "cmake_minimum_required(VERSION 3.0)\nproject(benchmark)\n",
        "benchmark/launch/run.launch": '<launch><include file="$(find robot_model)/launch/a.launch"/></launch>\n',
    }
    assert not [name for name in replaced(tmp_path, files, branch="melodic-devel") if name.startswith("today's")]
    files["requirements.txt"] = "transforms3d\n"
    found = replaced(tmp_path, files, branch="melodic-devel")
    assert found["apt source http://packages.ros.org/ros/ubuntu"] == "http://snapshots.ros.org/melodic/final/ubuntu"
    assert found["key of ROS in the image of melodic"].startswith("ros-snapshots, valid until 20")
    assert found["rosdep's index of today"].startswith("ros/rosdistro at melodic/")
    assert "apt archive of bionic" in found
    assert "pip<22" in found["today's pip, setuptools and wheel"]


def test_installers_are_named_where_a_step_brings_them(tmp_path: Path) -> None:
    files = {
        "README.md": "Tested on Ubuntu 18.04.\n",
        "CMakeLists.txt": "cmake_minimum_required(VERSION 3.0)\nproject(solver)\nadd_executable(solve a.cpp)\n",
        "a.cpp": "int main() { return 0; }\n",
        "roslab.yaml": "format: 3\nbase: {ubuntu: bionic}\n",
    }
    named = "today's pip, setuptools and wheel"
    assert named not in replaced(tmp_path / "alone", files)
    notebook = {"roslab.yaml": f"{files['roslab.yaml']}notebook: true\n"}
    assert "pip<22" in replaced(tmp_path / "notebook", files | notebook)[named]
    by_pip = {"roslab.yaml": f"{files['roslab.yaml']}pip: [numpy]\n"}
    assert "pip<22" in replaced(tmp_path / "by_pip", files | by_pip)[named]


def test_an_authors_dockerfile_on_a_deleted_image(tmp_path: Path) -> None:
    image = "nvidia/cuda:10.0-cudnn7-devel-ubuntu18.04"
    files = {
        "Dockerfile": f"FROM {image}\nRUN apt-get update && apt-get install -y python3\nCOPY . /app\n",
        "CMakeLists.txt": "project(x)\n",
        "roslab.yaml": "format: 3\ndockerfile: Dockerfile\n",
    }
    found = replaced(tmp_path, files)
    assert found[f"image {image}"].startswith("nvidia/cuda:1")


def test_what_answers_today_is_not_named(tmp_path: Path) -> None:
    assert replaced(tmp_path, {"main.py": "import numpy\n", "requirements.txt": "numpy\n"}) == {}
