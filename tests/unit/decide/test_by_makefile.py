"""Libraries that a page installs by a Makefile in a folder of theirs, and that the build lacks otherwise."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.decide.platforms import AMD64, ARM64
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
MADE = "project(arm)\nadd_executable(arm arm.cpp)\ntarget_link_libraries(arm {})\n"
BUILD = """\
git clone https://github.com/lab/MotorKit.git
cd {}MotorKit/c++/build/linux
make
sudo make install
"""
WORKFLOW = "jobs:\n  build:\n    steps:\n      - run: |\n{}"


def files(link: str, header: str, page: str = BUILD, home: str = "") -> dict[str, str]:
    code = f"#include <{header}>\nint main() {{}}\n"
    text = f"# Arm\n\n## Installation\n```\n{page.format(home)}```\n"
    return {"CMakeLists.txt": MADE.format(link), "arm.cpp": code, "README.md": text}


def built(decision: Decision) -> list[tuple[str, str | None, bool]]:
    return [(source.name, source.cmake_folder, source.by_make) for source in decision.source]


@pytest.mark.parametrize("home", ["", "~/", "/home/me/tools/"])
@pytest.mark.parametrize(("link", "header"), [("m", "motor_kit/motor.h"), ("mtk_x64", "motor.h")])
def test_it_is_built_where_its_makefile_lies(tree: Tree, link: str, header: str, home: str) -> None:
    decision = tree(files(link, header, home=home))
    assert built(decision) == [("MotorKit", "c++/build/linux", True)]
    assert not [w for w in decision.warnings if "nothing is known" in w.message or "not cloned" in w.message]


def test_so_does_the_authors_ci(tree: Tree) -> None:
    run = "".join(f"          {line}\n" for line in BUILD.format("").splitlines())
    there = files("mtk_x64", "motor.h", page="")
    assert built(tree(there | {".github/workflows/build.yml": WORKFLOW.format(run)})) == [
        ("MotorKit", "c++/build/linux", True)
    ]


@pytest.mark.parametrize(
    ("link", "header", "page"),
    [
        ("m", "motor.h", BUILD),  # nothing lacks it: it may be a driver
        ("mtk_x64", "motor.h", BUILD.replace("sudo make install\n", "")),
        ("mtk_x64", "motor.h", BUILD.replace("MotorKit", "eigen")),  # the Ubuntu has it
    ],
)
def test_others_are_not(tree: Tree, link: str, header: str, page: str) -> None:
    assert built(tree(files(link, header, page))) == []


def test_the_makefile_is_called_in_its_folder(tmp_path: Path) -> None:
    for name, text in files("mtk_x64", "motor.h").items():
        (tmp_path / name).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert ' && cd /tmp/sources/MotorKit/c++/build/linux \\\n && install-by-make "$(compile-jobs)"' in text


@pytest.mark.parametrize(
    ("link", "folder", "platforms"),
    [
        ("dxl_x64_cpp", "c++/build/linux64", (AMD64,)),
        ("dxl_sbc_cpp", "c++/build/linux_sbc", (AMD64, ARM64)),
    ],
)
def test_a_library_of_the_table_without_a_package_of_cmake(
    tree: Tree, link: str, folder: str, platforms: tuple[str, ...]
) -> None:
    decision = tree(files(link, "dynamixel_sdk/dynamixel_sdk.h", page=""))
    assert [(each.repo, each.cmake_folder, each.by_make) for each in decision.source] == [
        ("https://github.com/ROBOTIS-GIT/DynamixelSDK.git", folder, True)
    ]
    assert decision.platforms == platforms


def test_what_the_tree_makes_itself_is_not_built_beside_it(tree: Tree) -> None:
    there = files("dxl_x64_cpp", "a.h", page="")
    there["CMakeLists.txt"] += "add_subdirectory(dxl)\n"
    there["dxl/CMakeLists.txt"] = "add_library(dxl_x64_cpp dxl.cpp)\n"
    assert tree(there).source == ()
