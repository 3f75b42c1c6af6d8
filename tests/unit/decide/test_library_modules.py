"""Modules that only the source of a library holds: it is built, and pip installs them from its folder."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.knowledge.recipes import recipe

Tree = Callable[[dict[str, str]], Decision]
FOLDER = "file:///opt/acados/interfaces/acados_template"
MPC = "import casadi\nfrom acados_template import AcadosOcp\n"
MANIFEST = "<package format='3'><name>mpc</name><version>1.0.0</version><description>x</description>\
<maintainer email='a@b.c'>a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>\
<export><build_type>ament_cmake</build_type></export></package>"
CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject(mpc)\nfind_package(ament_cmake REQUIRED)\n"


def _libraries(found: Decision) -> list[str]:
    return [each.name for each in found.source]


@pytest.mark.parametrize(
    "files",
    [
        {"mpc.py": MPC},
        {"mpc.py": MPC, "requirements.txt": "numpy\nacados_template\n"},
        {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "scripts/mpc.py": MPC},
    ],
)
def test_what_imports_it_gets_the_library_the_module_and_the_variable(tree: Tree, files: dict[str, str]) -> None:
    found = tree(files)
    assert _libraries(found) == ["acados"]
    asked = [each.written for each in (*found.python.pip, *found.python.pip_guessed)]
    assert FOLDER in asked
    assert "acados_template" not in asked
    assert ("ACADOS_SOURCE_DIR", "/opt/acados") in found.variables
    assert not any("no table knows" in each.message for each in found.warnings)


def test_cmake_alone_gets_the_library_and_the_variable(tree: Tree) -> None:
    found = tree({"package.xml": MANIFEST, "CMakeLists.txt": f"{CMAKE}find_package(acados REQUIRED)\n"})
    assert _libraries(found) == ["acados"]
    assert ("ACADOS_SOURCE_DIR", "/opt/acados") in found.variables
    assert not found.python.pip_guessed


def test_a_submodule_of_it_is_what_is_meant(tree: Tree) -> None:
    modules = '[submodule "acados"]\n\tpath = external/acados\n\turl = https://github.com/acados/acados.git\n'
    found = tree({"mpc.py": MPC, ".gitmodules": modules})
    assert _libraries(found) == []


def test_nothing_for_a_test_alone(tree: Tree) -> None:
    found = tree({"mpc.py": "import casadi\n", "tests/test_mpc.py": MPC})
    assert _libraries(found) == []


@pytest.mark.parametrize(
    ("day", "ref"), [("2023-08-02", "v0.2.2"), ("2023-08-15", "v0.2.3"), ("2019-01-01", "v0.1.5"), (None, "v0.5.5")]
)
def test_the_release_is_that_of_the_day(day: str | None, ref: str) -> None:
    (built,) = recipe("acados", "jammy", day=day)
    assert built.ref == ref
