"""Packages of apt that only older Ubuntus have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

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
