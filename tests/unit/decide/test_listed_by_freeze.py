"""Lists that pip froze on an old Ubuntu name a part of setuptools as a package, which no index has."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize("name", ["pkg-resources", "pkg_resources"])
def test_it_is_left_out(tree: Tree, name: str) -> None:
    decision = tree({"requirements.txt": f"numpy==1.19.5\n{name}==0.0.0\n", "main.py": "import numpy\n"})
    assert [each.written for each in decision.python.pip] == ["numpy==1.19.5", "setuptools"]
    assert not decision.python.requirements
    assert any("pkg-resources" in told.message for told in decision.warnings)
