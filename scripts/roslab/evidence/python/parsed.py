"""The syntax tree of a Python file."""

from __future__ import annotations

import ast
import warnings


def parsed(text: str) -> ast.Module | None:
    """Return the tree of a file, ``None`` of one that Python 3 cannot read, as of Python 2."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about the code, which is not our user's to correct now
            return ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
