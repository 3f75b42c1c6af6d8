"""What the tree adds to Python's path, in code, scripts, settings and pages."""

from __future__ import annotations

import re

from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_PATH = pattern(r"^.*(?:sys\.path|PYTHONPATH|addsitedir).*$", re.MULTILINE)
_SAYS = (".sh", ".bash", ".zsh", ".md", ".rst", ".yml", ".yaml", ".ipynb", ".env")
_WORD = pattern(r"[\w.-]+")
MAX_READ = 128 * 1024
"""Bytes of a file that are searched."""


def on_path(repository: Repository) -> frozenset[str]:
    """Return the words of lines that add to Python's path, the names of folders among them."""
    files = [*repository.suffixed(".py", *_SAYS), *repository.named("Dockerfile")]
    texts = (repository.read(file, limit=MAX_READ) for file in files if file.size < 16 * MAX_READ)
    lines = (line for text in texts if "PATH" in text or "sys.path" in text for line in _PATH.findall(text))
    return frozenset(word for line in lines for word in _WORD.findall(line))
