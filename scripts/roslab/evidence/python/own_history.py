"""Code that opens the git repository that it lies in: an image has the files of a checkout, not its history."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_IMPORT = pattern(r"^[ \t]*(?:import git\b|from git(?:\.repo)? import [^\n]*\bRepo\b)", re.MULTILINE)
_OPENS = pattern(
    r"(?<![\w.])(?:git\.)?Repo\(\s*(?:path=)?"
    r"(?:\)|search_parent_directories=True|[\"']\.{1,2}/?[\"']|os\.getcwd\(\)|Path\.cwd\(\)|[^\n)]{0,80}\b__file__\b)"
)
"""``git.Repo()`` without a path, or with that of the code itself; a path that is a variable may be another one's.
https://gitpython.readthedocs.io/en/stable/reference.html#git.repo.base.Repo"""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such call of each module that goes on to ``except`` nowhere around it."""
    for module in modules(repository):
        text = module.text if "Repo" in module.words else ""
        if "Repo(" not in text or places.aside(module.file.path) or not _IMPORT.search(text):
            continue
        lines = text.split("\n")
        for number, line in enumerate(lines, start=1):
            code = line.partition("#")[0]
            if (found := _OPENS.search(code)) and not _tried(lines, number - 1):
                yield Mention(
                    topic="own_history", value="git", source="code", file=module.file.path, line=number, text=found[0]
                )
                break


def _tried(lines: Sequence[str], index: int) -> bool:
    """Tell whether a line stands in a ``try`` of its own function."""
    depth = _depth(lines[index])
    for line in reversed(lines[:index]):
        if line.strip() and _depth(line) < depth:
            depth = _depth(line)
            if line.strip().startswith("try:"):
                return True
            if line.strip().startswith("def "):
                return False
    return False


def _depth(line: str) -> int:
    return len(line) - len(line.lstrip())
