"""An author's option for a library that needs what the image does not have is dropped, and told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
DOCKER = """\
FROM ubuntu:20.04
RUN git clone --branch 3.5.5 https://github.com/casadi/casadi.git /opt/casadi && cd /opt/casadi && mkdir build && \\
    cd build && cmake .. -DWITH_IPOPT:BOOL=ON {} && make && make install
"""
FILES = {
    "CMakeLists.txt": "project(demo CXX)\nfind_package(casadi REQUIRED)\nadd_executable(demo demo.cpp)\n",
    "demo.cpp": "int main() {}\n",
}


@pytest.mark.parametrize(
    ("option", "kept"),
    [
        ("-DWITH_HSL:BOOL=ON", False),
        ("-DWITH_GUROBI=1", False),
        ("-DUSE_MOSEK=TRUE", False),
        ("-DWITH_PYTHON=ON", False),
        ("-DWITH_HSL=OFF", True),
        ("-DWITH_DEEPBIND=ON", True),
    ],
)
def test_what_the_stage_does_not_bring_is_not_switched_on(tree: Tree, option: str, *, kept: bool) -> None:
    found = tree({**FILES, "docker/Dockerfile": DOCKER.format(option)})
    (built,) = (source for source in found.source if source.name == "casadi")
    assert (option in built.cmake_options.split()) is kept
    assert "-DWITH_IPOPT:BOOL=ON" in built.cmake_options
    told = [w for w in found.warnings if option in w.message]
    assert [(w.file, w.line) for w in told] == ([] if kept else [("docker/Dockerfile", 2)])


def test_an_option_of_another_library_stays(tree: Tree) -> None:
    """WITH_PYTHON may find Python by other means elsewhere; what needs a licence needs it everywhere."""
    docker = DOCKER.replace("casadi/casadi", "lab/sieve").replace("casadi", "sieve")
    files = {**FILES, "CMakeLists.txt": FILES["CMakeLists.txt"].replace("casadi", "sieve")}
    found = tree({**files, "docker/Dockerfile": docker.format("-DWITH_PYTHON=ON -DWITH_KNITRO=ON")})
    (built,) = (source for source in found.source if source.name == "sieve")
    assert built.cmake_options.split() == ["-DWITH_IPOPT:BOOL=ON", "-DWITH_PYTHON=ON"]
