"""Code that asks git for the folder of the repository or its commit, and stops where the source is in none.

https://git-scm.com/docs/git-rev-parse#Documentation/git-rev-parse.txt---show-toplevel and
https://gitpython.readthedocs.io/en/stable/reference.html#git.repo.base.Repo, 2026-11-27.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import Literal

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import matching_lines
from roslab.evidence.native.asked_commit import asked_commit
from roslab.evidence.python.modules import modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_ASKS = pattern(
    r"^[^#\n]{0,300}?(?:\brev-parse[\"',\s]{1,9}(?:--show-toplevel|--git-dir)\b|\bsearch_parent_directories\s?=\s?True\b)",
    re.MULTILINE,
)
_WORDS = ("rev-parse", "search_parent_directories")


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return the first line of Python that does, also in a launch file, which a program of the image may run.

    Without one, the first call of CMake that does not compile where git knows of no commit.
    """
    return repository.once(_read)


def _read(repository: Repository) -> tuple[Mention, ...]:
    for module in modules(repository):
        if places.aside(module.file.path) or not any(word in module.text for word in _WORDS):
            continue
        for match in matching_lines(_ASKS, module.text, *_WORDS):
            line = module.text.count("\n", 0, match.start()) + 1
            said, file = match[0].strip(), module.file.path
            return (Mention(topic="git_folder", value="git", source="code", file=file, line=line, text=said),)
    return tuple(
        Mention(topic="git_folder", value="git", source="code", file=asked.path, line=line, text=said)
        for asked, line, said in islice(asked_commit(repository), 1)
    )


def needed(repository: Repository) -> Iterator[Dependency]:
    """Yield git itself, where the code asks it."""
    for said in read(repository):
        role: Literal["run", "called"] = "run" if said.file.endswith("CMakeLists.txt") else "called"
        yield Dependency(namespace="apt", name="git", strength="used", file=said.file, line=said.line, role=role)
