"""Small trees for the tests of decisions."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository


@pytest.fixture
def tree(tmp_path: Path) -> Callable[[dict[str, str]], Decision]:
    """Return a function that writes files and returns what is decided about them."""

    def write_and_decide(files: dict[str, str]) -> Decision:
        for path, text in files.items():
            target = tmp_path / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        return decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")

    return write_and_decide
