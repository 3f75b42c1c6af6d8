"""An option by which CMake is handed the folder of an archive gets the one that the image unpacks."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hanging import ends
from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
NAME = "acme-3.2.7-linux-x86_64.tar.gz"
URL = f"https://files.example/releases/{NAME}"
CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project(demo CXX)
if(NOT DEFINED ACME_ROOT)
  message(FATAL_ERROR "set ACME_ROOT")
endif()
link_directories(${ACME_ROOT}/lib)
add_executable(demo main.cpp)
target_link_libraries(demo acme)
"""
FILES = {"CMakeLists.txt": CMAKE, "main.cpp": "int main() {}\n"}
AT_HOME = f"mkdir -p ~/sdk && cd ~/sdk\nwget {URL}\ntar xf {NAME}"
ELSEWHERE = f"cd /opt\nsudo wget {URL}\nsudo tar xf {NAME}"


def of(tree: Tree, lines: str, call: str, **more: str) -> Decision:
    page = f"# Demo\n## Install\n```bash\n{lines}\n```\n## Build\n```bash\nmkdir build && cd build\n{call}\nmake\n```\n"
    return tree({**FILES, "README.md": page, **more})


@pytest.mark.parametrize(
    ("lines", "call", "folder"),
    [
        (AT_HOME, "cmake .. -DACME_ROOT=~/sdk/acme-3.2.7", "sdk"),
        (AT_HOME, "cmake .. -DACME_ROOT:PATH=$HOME/sdk/acme-3.2.7", "sdk"),
        (AT_HOME, "cmake .. -D ACME_ROOT=/home/me/sdk/acme-3.2.7/", "sdk"),
        (AT_HOME, 'cmake .. -DACME_ROOT="${HOME}/sdk/acme-3.2.7"', "sdk"),
        (ELSEWHERE, "cmake .. -DACME_ROOT=/opt/acme-3.2.7", "."),
    ],
)
def test_it_gets_the_folder_in_the_home(tree: Tree, lines: str, call: str, folder: str) -> None:
    decision = of(tree, lines, call)
    assert [each.unpack for each in decision.downloads if each.home and each.url == URL] == [folder]
    below = "sdk/acme-3.2.7" if folder == "sdk" else "acme-3.2.7"
    assert f"-DACME_ROOT=~/{below}" in decision.cmake_options
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    assert f"-DACME_ROOT=/home/${{NB_USER}}/{below}" in text


@pytest.mark.parametrize(
    ("lines", "call", "cmake"),
    [
        # another folder, a blank, an option that CMake here does not read, or sets itself
        (AT_HOME, "cmake .. -DACME_ROOT=~/sdk/other", CMAKE),
        (AT_HOME, "cmake .. -DACME_ROOT=<path to acme>", CMAKE),
        (AT_HOME, "cmake .. -DOTHER_ROOT=~/sdk/acme-3.2.7", CMAKE),
        (AT_HOME, "cmake .. -DACME_ROOT=~/sdk/acme-3.2.7", CMAKE.replace("if(NOT", "set(ACME_ROOT /usr)\nif(NOT")),
        # nothing is unpacked
        (f"wget {URL}", "cmake .. -DACME_ROOT=~/acme-3.2.7", CMAKE),
    ],
)
def test_it_is_left_as_it_is(tree: Tree, lines: str, call: str, cmake: str) -> None:
    decision = of(tree, lines, call, **{"CMakeLists.txt": cmake})
    assert not [word for word in decision.cmake_options if "~" in word]
    assert not [each for each in decision.downloads if each.home]


def test_the_page_and_the_script_are_two_files(tree: Tree) -> None:
    script = f"#!/bin/sh\ncd /root/install\nwget {URL}\ntar -zxvf {NAME}\n"
    decision = of(
        tree, "sh tools/acme.sh", "cmake .. -DACME_ROOT=/root/install/acme-3.2.7", **{"tools/acme.sh": script}
    )
    assert "-DACME_ROOT=~/install/acme-3.2.7" in decision.cmake_options
    assert decision.platforms == ("linux/amd64",)


def test_a_value_that_cmake_keeps_in_its_cache_may_be_handed(tree: Tree) -> None:
    cmake = CMAKE.replace("if(NOT", 'set(ACME_ROOT "/usr" CACHE PATH "where it is")\nif(NOT')
    found = of(tree, AT_HOME, "cmake .. -DACME_ROOT=~/sdk/acme-3.2.7", **{"CMakeLists.txt": cmake})
    assert "-DACME_ROOT=~/sdk/acme-3.2.7" in found.cmake_options


def test_what_is_hostile_takes_no_long_time(tree: Tree) -> None:
    cmake = CMAKE + "a(ACME_ROOT x " * 4_000
    with ends():
        of(tree, AT_HOME, "cmake .. " + "-DACME_ROOT=/a/b " * 10_000, **{"CMakeLists.txt": cmake})
