"""What is built with backends that compile nothing, beside packages that need others there before they are built."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
OWN = "[project]\nname='acme'\nversion='1'\ndependencies=['{}']\n[build-system]\nrequires=[{}]\nbuild-backend='{}'\n"
CODE = {"acme/__init__.py": "", "acme/run.py": "import lap\n"}


def test_an_editable_install_by_hatchling_beside_the_others_has_editables(tree: Tree) -> None:
    first = tree({"pyproject.toml": OWN.format("lap", "'hatchling'", "hatchling.build"), **CODE}).python.first
    assert {each.key for each in first} == {"numpy", "hatchling", "editables"}


def test_a_backend_that_is_asked_for_as_a_package_needs_nothing_first(tree: Tree) -> None:
    assert tree({"requirements.txt": "hatchling\nmeson-python\nsix\n", "run.py": "import six\n"}).python.first == ()


@pytest.mark.parametrize(
    ("needs", "backend", "apart"),
    [
        ("'hatchling'", "hatchling.build", True),
        ("'poetry-core>=1.0'", "poetry.core.masonry.api", True),
        ("'flit_core >=3.2,<4'", "flit_core.buildapi", True),
        ("'hatchling', 'numpy'", "hatchling.build", False),  # a hook of it may build with that
        ("'setuptools'", "setuptools.build_meta", False),
    ],
)
def test_only_who_needs_it_is_built_beside_the_others(tmp_path: Path, needs: str, backend: str, apart: bool) -> None:
    tree_of(tmp_path, {"pyproject.toml": OWN.format("lap", needs, backend), **CODE})
    plan = plan_repository(tmp_path).plan
    assert plan.python.isolated == ((".",) if apart else ())
    beside = 'python3 -m pip install "$(pip-cache)" --no-build-isolation --editable .'
    alone = f'{{ python3 -m pip install "$(pip-cache)" --editable . \\\n      || {beside}; }}'
    assert beside in dockerfile(plan)
    assert (alone in dockerfile(plan)) == apart


SETUP = """from setuptools import setup
{}
setup(name='acme', install_requires=['box2d-py'], ext_modules=[{}('acme.fast', [])])
"""
BY_PYBIND = "from pybind11.setup_helpers import Pybind11Extension"


@pytest.mark.parametrize(
    ("imported", "extension", "needs", "apart"),
    [
        (BY_PYBIND, "Pybind11Extension", "'setuptools>=42', 'wheel', 'pybind11'", True),
        ("from setuptools import Extension", "Extension", "'setuptools', 'Cython'", True),
        (BY_PYBIND, "Pybind11Extension", "'setuptools'", False),  # it imports more
        (f"{BY_PYBIND}\nimport numpy", "Pybind11Extension", "'setuptools', 'pybind11', 'numpy'", False),
        ("from torch.utils.cpp_extension import CppExtension", "CppExtension", "'setuptools', 'torch'", False),
        ("from torch.utils.cpp_extension import CUDAExtension", "CUDAExtension", "'setuptools', 'ninja'", False),
    ],
)
def test_an_extension_is_built_in_isolation_with_what_its_own_file_names(
    tmp_path: Path, imported: str, extension: str, needs: str, apart: bool
) -> None:
    backend = f"[build-system]\nrequires = [{needs}]\nbuild-backend = 'setuptools.build_meta'\n"
    tree_of(
        tmp_path, {"setup.py": SETUP.format(imported, extension), "pyproject.toml": backend, "acme/__init__.py": ""}
    )
    plan = plan_repository(tmp_path).plan
    assert "swig" in plan.python.first
    assert plan.python.isolated == ((".",) if apart else ())


def test_where_nothing_must_be_there_first_each_build_is_isolated_anyway(tree: Tree) -> None:
    decision = tree({"pyproject.toml": OWN.format("six", "'hatchling'", "hatchling.build"), **CODE})
    assert (decision.python.first, decision.python.isolated) == ((), ())
