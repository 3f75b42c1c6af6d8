"""Headers of packages outside the folders of the compiler are found by the path that the code writes."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TOP = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\n{}add_executable(a a.cpp)\n"
IPOPT = (("CPATH", "/usr/include/coin"), ("CXXFLAGS", "-DHAVE_CSTDDEF"))


@pytest.mark.parametrize(
    ("header", "cmake", "variables"),
    [
        ("IpTNLP.hpp", "", IPOPT),
        ("coin/IpTNLP.hpp", "", IPOPT[1:]),
        ("cppad/ipopt/solve.hpp", "", IPOPT[1:]),
        ("cholmod.h", "", (("CPATH", "/usr/include/suitesparse"),)),
        ("cholmod.h", "find_package(SuiteSparse)\n", ()),
        ("suitesparse/cholmod.h", "", ()),
        ("g2o/solvers/csparse/linear_solver_csparse.h", "", (("CPATH", "/usr/include/suitesparse"),)),
        (
            "g2o/solvers/csparse/linear_solver_csparse.h",
            "find_package(g2o REQUIRED)\n",
            (("CPATH", "/usr/include/suitesparse"),),
        ),
        ("g2o/solvers/csparse/linear_solver_csparse.h", "find_package(CSparse REQUIRED)\n", ()),
        ("g2o/solvers/dense/linear_solver_dense.h", "find_package(g2o REQUIRED)\n", ()),
        ("Eigen/Core", "", ()),
    ],
)
def test_the_folder_and_the_definition_are_told(
    tree: Tree, header: str, cmake: str, variables: tuple[tuple[str, str], ...]
) -> None:
    decision = tree({"CMakeLists.txt": TOP.format(cmake), "a.cpp": f"#include <{header}>\nint main() {{}}\n"})
    assert decision.variables == variables


def test_a_header_that_the_tree_has_is_no_packages(tree: Tree) -> None:
    files = {"CMakeLists.txt": TOP.format(""), "a.cpp": "#include <IpTNLP.hpp>\n", "ipopt/IpTNLP.hpp": ""}
    assert not tree(files).variables
