"""Options that the author's own Makefile or script gives CMake, where no page gives any."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
DECLARED = (
    "set(TASK a CACHE STRING x)\nset(TASK_DIR a CACHE STRING x)\noption(DEMO x)\noption(DEMO_FAST x)\n"
    "cmake_minimum_required(VERSION 3.10)\nproject(demo CXX)\nadd_executable(demo a.cpp)\n"
)
CODE = {
    "CMakeLists.txt": DECLARED,
    "a.cpp": "int main() {}\n",
    "README.md": "# Demo\n\n```\nmake\n```\n",
}


@pytest.mark.parametrize(
    ("makefile", "options"),
    [
        ("task ?= merge # or highway\n\nall:\n\tcmake -DCMAKE_BUILD_TYPE=Debug -DTASK_DIR=$(task) . -B$(task)/build\n",
         ("-DTASK_DIR=merge",)),
        ("type := 2\ntask = merge$(type)\nall:\n\t@mkdir -p build; cd build && cmake \\\n\t  -D TASK=${task} ..\n",
         ("-DTASK=merge2",)),
        ("ifdef X\ntask = a\nelse\ntask = b\nendif\nall:\n\tcmake -DTASK=$(task) -DDEMO=ON -Bbuild\n", ("-DDEMO=ON",)),
        ("all:\n\tcd third_party/lib && cmake -DTASK=merge .\n", ()),
        ("all:\n\tcmake -S third_party/lib -DTASK=merge\n", ()),
        ("all:\n\tcmake -DSDK_DIR=/opt/sdk -DTASK=$(shell pwd) .\n", ()),
        ("all:\n\tcmake --build build -DTASK=merge\n\n\tcmake -DTASK=later .\n", ("-DTASK=later",)),
        ("# cmake -DTASK=merge .\nall:\n\tg++ a.cpp\n", ()),
    ],
)  # fmt: skip
def test_the_makefile_at_the_root(tree: Tree, makefile: str, options: tuple[str, ...]) -> None:
    assert tree({**CODE, "Makefile": makefile}).cmake_options == options


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("build.sh", ("-DDEMO_FAST=ON",)),
        ("compile_all.sh", ("-DDEMO_FAST=ON",)),
        ("build_android.sh", ()),
        ("tools/build.sh", ()),
    ],
)
def test_a_script_that_builds(tree: Tree, name: str, options: tuple[str, ...]) -> None:
    script = "#!/bin/bash\nmkdir -p build\ncd build\ncmake .. -DDEMO_FAST=ON -DSDK_DIR=/opt/sdk\nmake -j4\n"
    assert tree({**CODE, name: script}).cmake_options == options


def test_a_page_comes_first(tree: Tree) -> None:
    page = "# Demo\n\n```\ncmake -B build -DTASK=page\n```\n"
    makefile = "all:\n\tcmake -DTASK=merge .\n"
    assert tree({**CODE, "README.md": page, "Makefile": makefile}).cmake_options == ("-DTASK=page",)
