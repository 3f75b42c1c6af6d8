"""Libraries that their authors compile, and that start only with a key of their user's."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.10)\nproject(gym CXX)\n{}\nadd_executable(run run.cpp)\n"
RUN = {"run.cpp": "int main() {}\n"}


@pytest.mark.parametrize("asked", ["find_package(raisim CONFIG REQUIRED)", "find_package(raisim REQUIRED)"])
def test_the_library_is_built_for_its_platform_and_the_key_is_told(tree: Tree, asked: str) -> None:
    decision = tree({**RUN, "CMakeLists.txt": CMAKE.format(asked)})
    assert [each.name for each in decision.source] == ["raisim"]
    assert "libeigen3-dev" in decision.apt_guessed
    assert decision.platforms == ("linux/amd64",)
    (told,) = [each for each in decision.warnings if "licence key" in each.message]
    assert (told.file, told.line) == ("CMakeLists.txt", 3)
    assert "~/.raisim/activation.raisim" in told.message


def test_it_is_built_for_an_extension_that_pip_compiles(tree: Tree) -> None:
    setup = "from setuptools import setup\nsetup(name='gym', ext_modules=[CMakeExtension('_gym')])\n"
    setup += "subprocess.check_call(['cmake', ext.sourcedir])\n"
    decision = tree({"CMakeLists.txt": CMAKE.format("find_package(raisim REQUIRED)"), "setup.py": setup})
    assert (decision.kind, [each.name for each in decision.source]) == ("python", ["raisim"])


def test_none_is_told_of_another_library(tree: Tree) -> None:
    decision = tree({**RUN, "CMakeLists.txt": CMAKE.format("find_package(rpclib REQUIRED)")})
    assert [each.name for each in decision.source] == ["rpclib"]
    assert not [each for each in decision.warnings if "licence key" in each.message]
