"""What lies at the top of a repository and no build file names: its pages, its notebooks, its settings."""

from __future__ import annotations

import posixpath
import re

from roslab.evidence.lex.lines import matches_at
from roslab.knowledge.unread import unread
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MOST = 8
"""Each is a line of the Dockerfile; of more, the first."""
_PROJECTS = ("package.xml", "setup.py", "pyproject.toml")
_PLAIN = pattern(r"[A-Za-z0-9._][A-Za-z0-9._-]*\Z")
"""A name that is one word of a Dockerfile."""
_EVERYTHING = pattern(r"\bDIRECTORY\s+\"?(?:\./?|\$\{\w+\}/?)\"?[\s)]|\bGLOB_RECURSE\b[^)]*[\s\"]\*[\s\")]")
"""CMake installs or lists a whole folder."""


def names(repository: Repository) -> tuple[str, ...]:
    """Return the names at the top that a build of the workspace certainly does not read, sorted.

    What any build file of the repository names, at the top or by another path, may be read; a folder with packages of
    ROS or projects of Python is.
    """
    top = {file.path.partition("/")[0] for file in repository.files}
    projects = {file.path.partition("/")[0] for file in repository.named(*_PROJECTS) if "/" in file.path}
    found = [name for name in sorted(top - projects) if _PLAIN.match(name) and unread().match(name)]
    if not found:
        return ()
    files = (
        *repository.named("CMakeLists.txt", "setup.py", "setup.cfg", "pyproject.toml", "MANIFEST.in"),
        *repository.suffixed(".cmake"),
    )
    texts = [repository.read(file) for file in files]
    if any(any(matches_at(_EVERYTHING, text, "DIRECTORY", "GLOB_RECURSE")) for text in texts):
        return ()
    lowered = [text.lower() for text in texts]
    return tuple(name for name in found if not any(_named(name.lower(), text) for text in lowered))[:MOST]


def _named(name: str, text: str) -> bool:
    """Tell whether a text names a file or a pattern of its suffix, both in lower case."""
    stem, suffix = posixpath.splitext(name)
    word = stem.lstrip(".") or name
    if word in text and re.search(rf"(?<![a-z0-9_]){re.escape(word)}(?![a-z0-9_])", text):
        return True
    return bool(suffix and f"*{suffix}" in text and re.search(rf"\*{re.escape(suffix)}\b", text))
