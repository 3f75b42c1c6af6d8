"""What the tree adds to Python's path, in code, scripts, settings and pages."""

from __future__ import annotations

from roslab.evidence.lex.lines import end_of_line, lines_with
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_WORDS = ("sys.path", "PYTHONPATH", "addsitedir")
_SAYS = (".sh", ".bash", ".zsh", ".md", ".rst", ".yml", ".yaml", ".ipynb", ".env")
_WORD = pattern(r"[\w.-]+")
MAX_READ = 128 * 1024
"""Bytes of a file that are searched."""


def on_path(repository: Repository) -> frozenset[str]:
    """Return the words of lines that add to Python's path, the names of folders among them."""
    files = [*repository.suffixed(".py", *_SAYS), *repository.named("Dockerfile")]
    texts = (repository.read(file, limit=MAX_READ) for file in files if file.size < 16 * MAX_READ)
    said = (text for text in texts if "PATH" in text or "sys.path" in text)
    lines = (text[start : end_of_line(text, start)] for text in said for start in lines_with(text, *_WORDS))
    return frozenset(word for line in lines for word in _WORD.findall(line))
