"""Definition files of Apptainer and Singularity."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.evidence.prose.definitions import as_dockerfile
from roslab.repository.checkout import Repository

HEADER = "# The image\nBootstrap: docker\nFrom: osrf/ros:noetic-desktop  # of ROS\n\n"
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}


def decided(folder: Path, files: dict[str, str]) -> Decision:
    for path, text in (FILES | files).items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    return decide(gather(Repository.open(folder)), Config(), folder_name="demo")


@pytest.mark.parametrize(
    ("lines", "instructions"),
    [
        (HEADER.splitlines(), ["#", "#", "FROM osrf/ros:noetic-desktop", "#"]),
        (["From: ros:noetic", "BootStrap: docker"], ["#", "#"]),
        (["Bootstrap: library", "From: lab/demo"], ["#", "#"]),
        (
            ["Bootstrap: debootstrap", "OSVersion: focal", "MirrorURL: http://archive.ubuntu.com/ubuntu/"],
            ["#", "#", "FROM ubuntu:focal"],
        ),
        (
            ["%post", "  apt-get install -y \\", "    yq", "", "%environment", "  export A=b", "  A=c"],
            ["#", "RUN apt-get install -y \\", "    yq", "#", "#", "ENV A=b", "#"],
        ),
        (["%files", "cuda-10.2 /usr/local", "%labels", "Author a"], ["#"] * 4),
        (["%runscript", '  exec python3 /opt/demo.py "$@"'], ["#", "CMD python3 /opt/demo.py"]),
        (["%runscript", "  cd /opt", "  ./run"], ["#"] * 3),
        (["%setup", "  apt-get install -y host", "%test", "  true"], ["#"] * 4),
    ],
)
def test_the_dockerfile_that_it_amounts_to(lines: list[str], instructions: list[str]) -> None:
    assert as_dockerfile("\n".join(lines)).split("\n") == instructions


@pytest.mark.parametrize("name", ["recipe.def", "singularity/Singularity", "Singularity.demo", "apptainer.def"])
def test_it_tells_the_base_and_what_is_installed(tmp_path: Path, name: str) -> None:
    post = "%post\n    apt-get update && apt-get install -y yq\n    pip install demo-tool==1.2\n"
    decision = decided(tmp_path, {name: HEADER + post})
    assert decision.ros_distro == "noetic"
    assert decision.dockerfile is None
    assert "yq" in decision.apt_guessed
    why = [each for each in decision.reasons if each.question == "ros_distro" and each.file == name]
    assert [(each.answer, each.line) for each in why if "starts from" in each.reason] == [("noetic", 3)]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("demo.def", "EXPORTS\n  Bootstrap\n"),
        ("Singularity.md", HEADER),
        ("docs/recipe.txt", HEADER),
    ],
)
def test_what_is_no_definition(tmp_path: Path, name: str, text: str) -> None:
    decision = decided(tmp_path, {name: text})
    assert not [each for each in decision.reasons if each.question == "ros_distro" and each.file == name]


def test_a_dockerfile_tells_more(tmp_path: Path) -> None:
    decision = decided(tmp_path, {"recipe.def": HEADER, "docker/Dockerfile": "FROM ros:melodic\nCOPY . /ws/src/demo\n"})
    assert decision.ros_distro == "melodic"


@pytest.mark.parametrize("name", ["Singularity.Dockerfile", "apptainer.dockerfile"])
def test_a_dockerfile_of_such_a_name_is_one(tmp_path: Path, name: str) -> None:
    decision = decided(tmp_path, {name: "FROM ros:noetic\nRUN apt-get update && apt-get install -y libfoo-dev\n"})
    assert "libfoo-dev" in (*decision.apt, *decision.apt_guessed)
