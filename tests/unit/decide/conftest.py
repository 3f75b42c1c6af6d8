"""Small trees for the tests of decisions."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from trees import decided


@pytest.fixture
def tree(tmp_path: Path) -> Callable[[dict[str, str]], Decision]:
    """Return a function that writes files and returns what is decided about them."""
    return partial(decided, tmp_path)
