"""A configure that CMake runs and that looks for a compiler of Fortran needs one, and so does its library."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
RUN = "execute_process(COMMAND bash ${PROJECT_SOURCE_DIR}/ThirdParty/${SOLVER}/configure --with-pic)\n"
FORTRAN = "AC_INIT([solver], [3.12])\nAC_COIN_PROG_F77\n"
PLAIN = "AC_INIT([solver], [3.12])\nAC_PROG_CXX\n"


@pytest.mark.parametrize(
    ("line", "made_of", "needed"),
    [
        (RUN, {"configure.ac": FORTRAN}, True),
        (RUN, {"parts/hsl/configure.in": "AC_PROG_FC\n"}, True),
        (RUN, {"configure": "for program in gfortran f77; do\n"}, True),
        (RUN, {"configure": "for program in gfortran f77; do\n", "configure.ac": PLAIN}, False),
        ("", {"configure.ac": FORTRAN}, False),
        (RUN.replace("ThirdParty", "other"), {"configure.ac": FORTRAN}, False),
        ("find_library(FORTRAN_LIBRARY NAMES gfortran PATHS /usr/lib/gcc)\n", {}, True),
    ],
)
def test_a_configure_that_looks_for_fortran(tree: Tree, line: str, made_of: dict[str, str], *, needed: bool) -> None:
    files = {
        "CMakeLists.txt": f"project(demo)\nset(SOLVER solver-3)\n{line}add_executable(demo main.cpp)\n",
        "main.cpp": "int main() {}\n",
        "ThirdParty/solver-3/configure": "#!/bin/sh\n",
    }
    decision = tree(files | {f"ThirdParty/solver-3/{name}": text for name, text in made_of.items()})
    assert ("gfortran" in (*decision.apt, *decision.apt_guessed)) == needed
