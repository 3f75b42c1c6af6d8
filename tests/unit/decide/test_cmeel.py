"""Libraries of C++ that CMake finds in wheels of pip, made by cmeel."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.decide.system.cmeel import with_wheels
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
PROGRAM = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.16)\nproject(walk CXX)\nfind_package(pinocchio REQUIRED)\n"
    "find_package(Eigen3 REQUIRED)\nadd_executable(walk walk.cpp)\ntarget_link_libraries(walk pinocchio::pinocchio)\n",
    "walk.cpp": "#include <pinocchio/multibody/model.hpp>\nint main() {}\n",
}
CI = ".github/workflows/ci.yml"
JOB = "jobs:\n  test:\n    runs-on: ubuntu-22.04\n    steps:\n      - run: {}\n"
USES = "python -m pip install {0}\n      - run: echo CMAKE_PREFIX_PATH=$(cmeel cmake) >> $GITHUB_ENV\n"
ENVIRONMENT = "name: walk\nchannels: [conda-forge]\ndependencies:\n  - eigen\n  - pinocchio=2.6.20\n"
MADE = "# Walk\nUbuntu 22.04\n```\nconda env create -f conda/dev.yml\nconda activate walk\n```\n"


@pytest.mark.parametrize(
    ("more", "wheels"),
    [
        ({CI: JOB.format(USES.format("pin[build]"))}, ["pin[build]"]),
        ({CI: JOB.format(USES.format("'crocoddyl[build]' gcovr"))}, ["crocoddyl[build]"]),
        ({CI: JOB.format(USES.format("'pin[build]>=3,<4'"))}, ["pin[build]<4,>=3"]),
        ({CI: JOB.format(USES.format("pin[build]==3.2.0"))}, ["pin[build]==3.2.0"]),
        ({"README.md": "# Walk\nUbuntu 22.04\n```\npip install pin\n```\n"}, ["pin[build]"]),
        ({"README.md": "# Walk\nUbuntu 22.04\n```\nconda install pinocchio -c conda-forge\n```\n"}, ["pin[build]"]),
        ({"environment.yml": ENVIRONMENT}, ["pin[build]"]),
        ({"conda/dev.yml": ENVIRONMENT, "README.md": MADE}, ["pin[build]"]),
    ],
)
def test_it_comes_from_the_wheel(tree: Tree, more: dict[str, str], wheels: list[str]) -> None:
    decision = tree({**PROGRAM, **more})
    asked = [each.written for each in (*decision.python.pip, *decision.python.pip_guessed)]
    assert [each for each in asked if "[build]" in each] == wheels
    assert not [each.name for each in decision.source]
    assert "libeigen3-dev" in {*decision.apt, *decision.apt_guessed}
    path = dict(decision.variables)["CMAKE_PREFIX_PATH"]
    assert "/usr/local/lib/python3.10/dist-packages/cmeel.prefix" in path.split(":")
    assert dict(decision.variables)["LD_LIBRARY_PATH"].endswith("cmeel.prefix/lib")


def test_so_do_the_wheels_that_a_wheel_requires(tree: Tree) -> None:
    asked = {"CMakeLists.txt": PROGRAM["CMakeLists.txt"].replace("pinocchio REQUIRED", "hpp-fcl REQUIRED")}
    decision = tree({**PROGRAM, **asked, CI: JOB.format(USES.format("'crocoddyl[build]'"))})
    asked_of_pip = [each.written for each in (*decision.python.pip, *decision.python.pip_guessed)]
    assert "crocoddyl[build]" in asked_of_pip
    assert not decision.source


def test_a_header_is_of_the_wheel_by_its_folder(tmp_path: Path) -> None:
    code = "#include <hpp/fcl/shape/convex.h>\n#include <pinocchio/multibody/model.hpp>\n#include <walk/walk.hpp>\n"
    tree_of(tmp_path, {**PROGRAM, "walk.cpp": code, CI: JOB.format(USES.format("pin[build]"))})
    found = gather(Repository.open(tmp_path))
    left = with_wheels(found, "cpp", "walk").code
    assert {each.name for each in found.code} - {each.name for each in left} == {
        "hpp/fcl/shape/convex.h",
        "pinocchio/multibody/model.hpp",
    }


@pytest.mark.parametrize(
    ("files", "more"),
    [
        (PROGRAM, {}),
        (PROGRAM, {CI: JOB.format("pip install pin")}),  # for its tests
        (PROGRAM, {CI: JOB.format(USES.format("tsid"))}),
        (PROGRAM, {"conda/dev.yml": ENVIRONMENT}),  # no page makes it
        (PROGRAM, {"environment-macos.yml": ENVIRONMENT}),
        (
            {**PROGRAM, "CMakeLists.txt": PROGRAM["CMakeLists.txt"].replace("(walk CXX)", "(pinocchio CXX)")},
            {"README.md": "# Pinocchio\n```\npip install pin\n```\n"},
        ),
        ({**PROGRAM, "CMakeLists.txt": "project(walk)\nadd_executable(walk walk.cpp)\n"}, {CI: JOB.format(USES)}),
    ],
)
def test_where_no_wheel_is_meant(tree: Tree, files: dict[str, str], more: dict[str, str]) -> None:
    assert "CMAKE_PREFIX_PATH" not in dict(tree({**files, **more}).variables)
