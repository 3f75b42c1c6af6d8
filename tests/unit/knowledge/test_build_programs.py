"""What a build lacks is told by Python's own messages, which name the outermost part that is not there."""

from __future__ import annotations

import importlib
import re

import pytest

from roslab.knowledge.build_programs import build_programs

ROWS = [line.partition(" ")[::2] for line in build_programs().splitlines()]


def brought_for(message: str) -> list[str]:
    return [package for package, pattern in ROWS if re.search(pattern, message, re.MULTILINE)]


@pytest.mark.parametrize(
    ("backend", "package"),
    [
        ("poetry.core.masonry.api", "poetry-core"),
        ("pdm.backend", "pdm-backend"),
        ("flit_core.buildapi", "flit-core"),
        ("hatchling.build", "hatchling"),
        ("mesonpy", "meson-python"),
        ("scikit_build_core.build", "scikit-build-core"),
    ],
)
def test_a_backend_that_is_not_there_as_a_whole_or_in_part(backend: str, package: str) -> None:
    parts = backend.split(".")
    for name in {parts[0], ".".join(parts[:2])}:
        assert brought_for(f"ModuleNotFoundError: No module named '{name}'") == [package]
    with pytest.raises(ModuleNotFoundError) as raised:
        importlib.import_module(f"absent_{backend}")
    assert str(raised.value) == f"No module named 'absent_{parts[0]}'"


def test_the_backend_that_poetry_itself_was_before_poetry_core() -> None:
    assert brought_for("ModuleNotFoundError: No module named 'poetry.masonry'") == ["poetry"]


@pytest.mark.parametrize("module", ["poetry_dynamic_versioning", "pdmtools", "poetryx.core"])
def test_another_module_of_a_name_that_begins_so(module: str) -> None:
    assert brought_for(f"ModuleNotFoundError: No module named '{module}'") == []
