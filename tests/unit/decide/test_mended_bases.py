"""Which images of an author's Dockerfile no longer answer, and what its build starts from instead."""

from __future__ import annotations

from pathlib import Path

import pytest
from packaging.requirements import Requirement

from roslab.pipeline import plan_repository
from roslab.plan.author_bases import Base

FILES = {"CMakeLists.txt": "cmake_minimum_required(VERSION 3.0)\nproject(robot CXX)\n", "main.cpp": "int main() {}\n"}


def bases(folder: Path, dockerfile: str, config: str = "") -> tuple[Base, ...]:
    lines = f"format: 3\nkind: cpp\ndockerfile: Dockerfile\n{config}"
    for path, text in {**FILES, "Dockerfile": dockerfile, "roslab.yaml": lines}.items():
        (folder / path).write_text(text)
    authored = plan_repository(folder).plan.author_dockerfile
    assert authored
    return authored.bases


@pytest.mark.parametrize(
    ("name", "image"),
    [
        ("ros:kinetic-perception", "ros:kinetic-perception"),
        ("osrf/ros:melodic-desktop-full", "osrf/ros:melodic-desktop-full"),
        ("docker.io/library/ros:foxy", "docker.io/library/ros:foxy"),
        ("ubuntu:16.04", "ubuntu:16.04"),
        ("ubuntu:bionic", "ubuntu:bionic"),
        ("ubuntu:17.10", "ubuntu:17.10"),
        ("debian:stretch-slim", "debian:stretch-slim"),
        ("debian:9", "debian:9"),
        ("python:2.7", "python:2.7"),
        ("python:3.7-buster", "python:3.7-buster"),
        ("nvidia/cuda:11.3.1-cudnn8-devel-ubuntu20.04", "nvidia/cuda:11.3.1-cudnn8-devel-ubuntu20.04"),
        ("nvidia/cuda:11.3.0-devel-ubuntu20.04", "nvidia/cuda:11.3.1-devel-ubuntu20.04"),
        ("nvidia/cuda:10.0-cudnn7-devel-ubuntu18.04", "nvidia/cuda:11.0.3-cudnn8-devel-ubuntu18.04"),
        ("nvidia/cuda:8.0-cudnn5-runtime-ubuntu14.04", "nvidia/cuda:11.0.3-cudnn8-runtime-ubuntu16.04"),
        ("nvidia/cudagl:11.3.1-devel-ubuntu20.04", "nvidia/cuda:11.3.1-devel-ubuntu20.04"),
    ],
)
def test_a_base_that_no_longer_answers_is_replaced(tmp_path: Path, name: str, image: str) -> None:
    (base,) = bases(tmp_path, f"FROM {name}\nCOPY . /source\n")
    assert (base.name, base.image) == (name, image)
    assert base.why


@pytest.mark.parametrize(
    "name",
    ["ubuntu:24.04", "ros:jazzy", "python:3.12", "debian:bookworm", "nvidia/cuda:12.4.1-devel-ubuntu22.04", "me/own:1"],
)
def test_a_base_that_answers_stays(tmp_path: Path, name: str) -> None:
    assert bases(tmp_path, f"FROM {name}\nCOPY . /source\n") == ()


def test_every_stage_is_read_and_each_base_replaced_once(tmp_path: Path) -> None:
    text = (
        "ARG DISTRO=kinetic\nFROM ros:${DISTRO} AS first\nFROM first AS second\nFROM ubuntu:18.04\nFROM ros:kinetic\n"
        "FROM scratch\nCOPY --from=second / /\nCOPY . /source\n"
    )
    found = bases(tmp_path, text)
    assert [base.name for base in found] == ["ros:kinetic", "ubuntu:18.04"]
    kinetic, bionic = found
    assert kinetic.sources
    assert kinetic.sources.ros
    assert kinetic.sources.ros.url == "http://snapshots.ros.org/kinetic/final/ubuntu"
    assert kinetic.rosdistro_tag == "kinetic/2021-05-11"
    assert 'pip<21; python_version < "3"' in kinetic.installers
    assert bionic.sources
    assert (bionic.sources.ros, bionic.sources.ended, bionic.rosdistro_tag) == (None, True, None)


@pytest.mark.parametrize(
    "name",
    ["ros:kinetic", "ubuntu:18.04", "nvidia/cuda:10.0-devel-ubuntu18.04", "nvidia/cuda:12.0.0-devel-ubuntu22.04"],
)
def test_pip_can_read_every_bound_of_a_replaced_base(tmp_path: Path, name: str) -> None:
    (base,) = bases(tmp_path, f"FROM {name}\nCOPY . /source\n")
    bounds = [Requirement(line) for line in base.installers]  # it raises what pip would stop with
    assert bounds
    assert all(bound.marker and bound.specifier for bound in bounds)


def test_each_step_from_a_deleted_cuda_to_the_nearest_is_told(tmp_path: Path) -> None:
    (tmp_path / "requirements.txt").write_text("tensorflow-gpu==1.13.1\n")
    (tmp_path / "main.py").write_text("import tensorflow\n\ntensorflow.Session()\n")
    said = [warning.message for warning in plan_repository(tmp_path).plan.warnings]
    assert any("CUDA 10.0: its images were deleted" in text and "the image has 11.0.3" in text for text in said), said


def test_nothing_is_replaced_where_the_author_does_not_want_it(tmp_path: Path) -> None:
    assert bases(tmp_path, "FROM ros:kinetic\nCOPY . /source\n", "repair: false\n") == ()
