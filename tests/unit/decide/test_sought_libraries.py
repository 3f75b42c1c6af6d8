"""Libraries that nothing known brings to plain C++, and where the build looks for them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LAB = "https://github.com/lab"
OPTION = "option(WITH_SIM 'with it' ON)\nif(WITH_SIM)\nfind_package(acmesim REQUIRED)\nendif()"
PACKAGE = "<package format='2'><name>arm</name>{}<export><build_type>cmake</build_type></export></package>"


def _files(cmake: str, *, origin: str = f"{LAB}/arm.git", more: dict[str, str] | None = None) -> dict[str, str]:
    text = f"cmake_minimum_required(VERSION 3.5)\nproject(arm)\n{cmake}\nadd_executable(arm arm.cpp)\n"
    git = {".git/config": f'[remote "origin"]\n\turl = {origin}\n', ".git/HEAD": "ref: refs/heads/a\n"}
    return {"CMakeLists.txt": text, "arm.cpp": "int main() { return 0; }\n", **git, **(more or {})}


def _sought(decision: Decision) -> list[str]:
    return [(source.repo or "").removesuffix(".git") for source in decision.source if source.holding]


def test_it_is_looked_for_in_a_repository_of_its_name_of_the_same_owner(tree: Tree) -> None:
    decision = tree(_files("find_package(Eigen3 REQUIRED)\nfind_package(acmesim 0.4 REQUIRED)"))
    assert _sought(decision) == [f"{LAB}/acmesim"]
    (source,) = decision.source
    assert (source.build, source.unasked, source.unread, source.holding) == ("cmake", True, True, ("acmesim",))
    told = next(each.message for each in decision.warnings if "nothing is known that brings acmesim" in each.message)
    assert f"looks for it in {LAB}/acmesim, and where it is not there, cmake will stop at arm" in told


def test_what_a_manifest_needs_to_build_is_looked_for_too(tree: Tree) -> None:
    needs = "<depend>acmesim</depend><depend>eigen</depend><depend>roscpp</depend><depend>acme_catkin</depend>"
    needs += "<exec_depend>acmeviewer</exec_depend>"
    decision = tree(_files("", more={"package.xml": PACKAGE.format(needs)}))
    assert (decision.kind, _sought(decision)) == ("cpp", [f"{LAB}/acmesim"])


def test_a_manifest_for_catkin_tells_nothing_of_what_cmake_alone_needs(tree: Tree) -> None:
    needs = "<buildtool_depend>catkin</buildtool_depend><depend>acme_catkin</depend>"
    page = {
        "README.md": "# Arm\n```\nmkdir build && cd build\ncmake ..\nmake\n```\n",
        "b.cpp": "#include <Eigen/Core>\n",
    }
    manifest = f"<package format='2'><name>arm</name>{needs}</package>"
    decision = tree(_files("", more={"package.xml": manifest, **page}))
    assert (decision.kind, _sought(decision)) == ("cpp", [])


@pytest.mark.parametrize(
    ("cmake", "origin"),
    [
        ("find_package(acmesim REQUIRED)", "/home/somebody/arm"),
        ("find_package(acmesim REQUIRED)", f"{LAB}/acmesim.git"),  # the repository itself
        ("find_package(acmesim)", f"{LAB}/arm.git"),
        ("find_package(DART REQUIRED)", f"{LAB}/arm.git"),
        ("find_package(urdf REQUIRED)", f"{LAB}/arm.git"),  # others publish it
        (OPTION, f"{LAB}/arm.git"),
        ("find_package(ac REQUIRED)", f"{LAB}/arm.git"),
    ],
)
def test_what_is_looked_for_nowhere(tree: Tree, cmake: str, origin: str) -> None:
    assert _sought(tree(_files(cmake, origin=origin))) == []


@pytest.mark.parametrize("name", ["acme_cmake_modules", "acmesim"])
def test_modules_of_cmake_may_find_more_than_their_own_name(tree: Tree, name: str) -> None:
    decision = tree(_files(f"find_package({name} REQUIRED)\nfind_package(Qq REQUIRED)"))
    told = next(each.message for each in decision.warnings if "that brings Qq" in each.message)
    assert (f"the build looks for it in {LAB}/{name}, and" in told) is name.endswith("modules")
