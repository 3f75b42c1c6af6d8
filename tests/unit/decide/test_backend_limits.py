"""A build backend of which newer releases refuse the project's own settings."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROJECT = """[project]
name = "demo"
version = "1"
[build-system]
requires = ["{backend}", "pybind11"]
build-backend = "scikit_build_core.build"
[tool.scikit-build]
{settings}
"""
OLD = 'cmake.minimum-version = "3.16"'


@pytest.mark.parametrize(
    ("backend", "settings", "first"),
    [
        ("scikit_build_core", OLD, ["scikit-build-core<1"]),
        ("scikit-build-core>=0.4", f"{OLD}\ncmake.verbose = true", ["scikit-build-core<1"]),
        ("scikit-build-core", 'cmake.version = ">=3.16"', []),
        ("scikit-build-core", f'{OLD}\nminimum-version = "0.5"', []),
        ("scikit-build-core==0.11.6", OLD, []),
        ("scikit-build-core>=1.0", OLD, []),
    ],
)
def test_a_setting_limits_the_backend(tree: Tree, backend: str, settings: str, first: list[str]) -> None:
    files = {
        "pyproject.toml": PROJECT.format(backend=backend, settings=settings),
        "CMakeLists.txt": "cmake_minimum_required(VERSION 3.16)\nproject(demo)\n",
        "src/demo/__init__.py": "",
    }
    found = [each.written for each in tree(files).python.first]
    assert [each for each in found if each.startswith("scikit")] == first
