"""What waits for a variable that a CMakeLists.txt sets to false, and never to anything else, is not asked for."""

from __future__ import annotations

import pytest

from roslab.evidence.lex.cmake import calls

FINDS = frozenset({"find_package", "target_link_libraries"})


def found(text: str) -> list[tuple[str, ...]]:
    return [(call.words[0], *call.conditions) for call in calls(text, FINDS)]


@pytest.mark.parametrize(
    "block",
    [
        "if(HAVE_G2O)\nfind_package(G2O)\nendif(HAVE_G2O)\n",
        "if(${HAVE_G2O})\nfind_package(G2O)\nendif()\n",
        "if(HAVE_G2O AND UNIX)\nfind_package(G2O)\nendif()\n",
        "if(UNIX)\nif(HAVE_G2O)\nfind_package(G2O)\nendif()\nendif()\n",
        "if(HAVE_G2O)\nset(MORE a)\nelseif(OTHER)\nendif()\n",
    ],
)
def test_what_waits_for_a_constant_is_left_out(block: str) -> None:
    assert found(f"SET(HAVE_G2O false)  # set(HAVE_G2O true)\n{block}find_package(Eigen3)\n") == [("Eigen3",)]


def test_its_else_is_always_built_and_its_variables_have_no_value() -> None:
    text = "set(X OFF)\nif(X)\nlist(APPEND LIBS cholmod)\nelse()\nlist(APPEND LIBS m)\nfind_package(A)\nendif()\n"
    assert found(text) == [("A", "NOT (NEVER X)")]
    (call,) = calls(f"{text}target_link_libraries(demo ${{LIBS}})\n", frozenset({"target_link_libraries"}))
    assert call.words == ("demo", "m")


@pytest.mark.parametrize(
    "text",
    [
        "set(X OFF)\nset(X ON)\n",
        "set(X ON)\nset(X OFF)\n",
        "set(X ON CACHE BOOL words)\n",
        "if(UNIX)\nset(X ON)\nendif()\n",
        "set(X ON)\nfind_library(X x)\n",
        "if(UNIX)\nset(X OFF)\nendif()\n",
        "set(X OFF CACHE BOOL words)\n",
        "set(X OFF)\ncheck_include_file(x.h X)\n",
        "set(X OFF)\nfind_library(X x)\n",
        "set(X OFF)\nforeach(X a b)\nendforeach()\n",
        "function(f)\nset(X OFF)\nendfunction()\n",
    ],
)
def test_what_may_be_set_is_no_constant(text: str) -> None:
    assert found(f"{text}if(X)\nfind_package(G2O)\nendif()\n") == [("G2O", "X")]


@pytest.mark.parametrize("condition", ["NOT X", "X OR UNIX", "X LESS 3", "DEFINED X"])
def test_a_condition_that_may_hold_all_the_same(condition: str) -> None:
    assert found(f"set(X 0)\nif({condition})\nfind_package(G2O)\nendif()\n") == [("G2O", condition)]


def test_what_finding_a_package_sets_is_none() -> None:
    text = "set(A_FOUND FALSE)\nfind_package(A)\nif(A_FOUND)\nfind_package(B)\nendif()\n"
    assert [each[0] for each in found(text)] == ["A", "B"]


@pytest.mark.parametrize(
    ("block", "conditions"),
    [
        ("if(X)\nfind_package(G2O)\nendif()\n", [()]),
        ("if(${X})\nfind_package(G2O)\nadd_definitions(-DX)\nendif(X)\n", [()]),
        ("if(X AND UNIX)\nfind_package(G2O)\nendif()\n", [("UNIX",)]),
        ("if(UNIX)\nif(X)\nfind_package(G2O)\nendif()\nendif()\n", [("UNIX",)]),
        ("if(A)\nelseif(X)\nfind_package(G2O)\nendif()\n", [("X",)]),
        ("if(X OR A)\nfind_package(G2O)\nendif()\n", [("X OR A",)]),
        ("if(NOT X)\nfind_package(Old)\nelse()\nfind_package(G2O)\nendif()\n", [("NOT (NEVER NOT X)",)]),
        ("if(X)\nelseif(A)\nfind_package(Old)\nelse()\nfind_package(Older)\nendif()\n", []),
    ],
)
def test_what_waits_for_a_variable_that_stays_true_is_always_built(block: str, conditions: list[tuple[str]]) -> None:
    got = found(f"set(X on)\n{block}find_package(Eigen3)\n")
    assert got == [("G2O", *each) for each in conditions] + [("Eigen3",)]


def test_a_variable_set_after_its_condition_decides_nothing() -> None:
    assert found("if(X)\nfind_package(G2O)\nendif()\nset(X ON)\n") == [("G2O", "X")]
