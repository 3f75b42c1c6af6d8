"""Packages of apt that only older Ubuntus have."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from trees import decided

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 2.8)\nproject(demo)\nadd_executable(demo a.cpp)\n"


def page(*names: str, said: str = "") -> dict[str, str]:
    text = f"# Demo\n{said}\n```\nsudo apt-get install {' '.join(names)}\n```\n"
    return {"CMakeLists.txt": CMAKE, "a.cpp": "int main() {}\n", "README.md": text}


@pytest.mark.parametrize(
    ("names", "said", "ubuntu"),
    [
        (("cmake",), "", "jammy"),
        (("libboost1.54-dev",), "", "trusty"),
        (("libboost-system1.58.0", "libpng12-dev"), "", "xenial"),
        (("python-pip", "git"), "", "bionic"),
        (("libqt4-dev", "libpng12-dev"), "", "xenial"),
        (("libboost1.54-dev", "libboost1.71-dev"), "", "jammy"),  # for different machines
        (("libboost1.74-dev",), "", "jammy"),
        (("python-pip",), "Tested on Ubuntu 20.04.", "focal"),
    ],
)
def test_the_ubuntu_of_the_packages_where_none_is_named(
    tree: Tree, names: tuple[str, ...], said: str, ubuntu: str
) -> None:
    assert tree(page(*names, said=said)).ubuntu == ubuntu


@pytest.mark.parametrize(
    ("lines", "ubuntu"),
    [("find_package(Eigen3 REQUIRED)\n", "bionic"), ("find_package(OpenCV 4 REQUIRED)\n", "focal")],
)
def test_one_on_which_the_code_does_not_compile_is_not_taken_for_them(tmp_path: Path, lines: str, ubuntu: str) -> None:
    files = {**page("python-pip"), "CMakeLists.txt": CMAKE.replace("add_exec", f"{lines}add_exec")}
    assert decided(tmp_path, files, "2022-01-01").ubuntu == ubuntu


@pytest.mark.parametrize(
    ("names", "day", "ubuntu"),
    [
        (("python-pip",), "2022-01-01", "bionic"),
        (("python-pip", "python-wstool"), "2023-11-01", "jammy"),  # the page was not changed when its authors moved
        (("libqt4-dev",), "2023-11-01", "bionic"),  # no newer Ubuntu has it under another name
        (("libqt4-dev", "python-pip"), "2023-11-01", "bionic"),
    ],
)
def test_an_old_name_of_a_tool_tells_nothing_years_later(
    tmp_path: Path, names: tuple[str, ...], day: str, ubuntu: str
) -> None:
    assert decided(tmp_path, page(*names), day).ubuntu == ubuntu


def test_one_whose_cmake_is_too_old_is_not_taken_for_them(tree: Tree) -> None:
    assert tree({**page("python-pip"), "CMakeLists.txt": CMAKE.replace("2.8", "3.16")}).ubuntu == "jammy"
