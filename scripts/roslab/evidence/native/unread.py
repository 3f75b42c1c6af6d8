"""What lies at the top of a repository and no build file names: its pages, its notebooks, its settings."""

from __future__ import annotations

import posixpath
import re

from roslab.knowledge.unread import unread
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MOST = 8
"""Each is a line of the Dockerfile; of more, the first."""
_PLAIN = pattern(r"[A-Za-z0-9._][A-Za-z0-9._-]*\Z")
"""A name that is one word of a Dockerfile."""
_EVERYTHING = pattern(r"\bDIRECTORY\s+\"?(?:\./?|\$\{\w+\}/?)\"?[\s)]|\bGLOB_RECURSE\b[^)]*[\s\"]\*[\s\")]")
"""CMake installs or lists a whole folder."""


def names(repository: Repository) -> tuple[str, ...]:
    """Return the names at the top that a build of the workspace certainly does not read, sorted.

    What any build file of the repository names, at the top or by another path, may be read.
    """
    top = sorted({file.path.partition("/")[0] for file in repository.files})
    found = [name for name in top if _PLAIN.match(name) and unread().match(name)]
    if not found:
        return ()
    files = (
        *repository.named("CMakeLists.txt", "setup.py", "setup.cfg", "pyproject.toml", "MANIFEST.in"),
        *repository.suffixed(".cmake"),
    )
    texts = [repository.read(file) for file in files]
    if any(_EVERYTHING.search(text) for text in texts):
        return ()
    return tuple(name for name in found if not any(_named(name, text) for text in texts))[:MOST]


def _named(name: str, text: str) -> bool:
    stem, suffix = posixpath.splitext(name)
    word = re.escape(stem.lstrip(".") or name)
    pattern = rf"(?<![A-Za-z0-9_]){word}(?![A-Za-z0-9_])" + (rf"|\*{re.escape(suffix)}\b" if suffix else "")
    return bool(re.search(pattern, text, re.IGNORECASE))
