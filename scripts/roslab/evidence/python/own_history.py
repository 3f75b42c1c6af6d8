"""Code that asks the git repository that it lies in: an image has the files of a checkout, not its history."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.indents import depth
from roslab.evidence.python.modules import modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_IMPORT = pattern(r"^[ \t]*(?:import git\b|from git(?:\.repo)? import [^\n]*\bRepo\b)", re.MULTILINE)
_WORDS = frozenset({"Repo", "subprocess"})
MOST = 20
"""Most calls of a module that are looked at."""
_OPENS = pattern(
    r"(?<![\w.])(?:git\.)?Repo\((?![^\n]{0,120}\bsearch_parent_directories\s?=\s?True\s?\)\.working_(?:tree_)?dir\b)"
    r"\s*(?:path=)?"
    r"(?:\)|search_parent_directories=True|[\"']\.{1,2}/?[\"']|os\.getcwd\(\)|Path\.cwd\(\)|[^\n)]{0,80}\b__file__\b)"
)
"""``git.Repo()`` without a path, or with that of the code itself; a path that is a variable may be another one's.
Not where only the folder is asked for, in which it lies.
https://gitpython.readthedocs.io/en/stable/reference.html#git.repo.base.Repo"""

_CALLS = pattern(
    r"(?<!\w)check_output\(\s{0,40}[\[(]?\s{0,40}[\"']git[\"',\s]{1,9}"
    r"(?:rev-parse(?![\"',\s]{1,9}--(?:show-toplevel|git-dir)\b)|log|show|status|diff|branch|symbolic-ref)\b"
    r"(?![^\n]{0,200}\bcwd[ \t]*=(?![^\n]{0,80}__file__))"
)
"""What fails where there is no repository, and raises then; not in the folder of another one, nor for the folder alone.
https://docs.python.org/3/library/subprocess.html#subprocess.check_output, read 2026-11-28."""
_WITHOUT_MODULE = pattern(
    r"except[ \t]{0,9}\(?[ \t]{0,9}(?:(?:ImportError|ModuleNotFoundError)[, \t]{0,9})+\)?[ \t]{0,9}"
    r"(?:as[ \t]+\w+[ \t]*)?:"
)
"""It goes on without GitPython, not without a repository."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such call of each module that goes on to ``except`` nowhere around it."""
    for module in modules(repository):
        text = "" if module.words.isdisjoint(_WORDS) or places.aside(module.file.path) else module.text
        opens = "Repo(" in text and _IMPORT.search(text)
        if not opens and "check_output(" not in text:
            continue
        lines = text.split("\n")
        found = (
            *(_by_line(lines) if opens else ()),
            *((text.count("\n", 0, match.start()), match[0]) for match in _CALLS.finditer(text)),
        )
        for index, said in sorted(found)[:MOST]:
            if "#" not in lines[index].partition(said[:12])[0] and not _tried(lines, index):
                yield Mention(
                    topic="own_history", value="git", source="code", file=module.file.path, line=index + 1, text=said
                )
                break


def _by_line(lines: Sequence[str]) -> Iterator[tuple[int, str]]:
    for index, line in enumerate(lines):
        if found := _OPENS.search(line.partition("#")[0]):
            yield index, found[0]


def _tried(lines: Sequence[str], index: int) -> bool:
    """Tell whether a line stands in a ``try`` of its own function that goes on without a repository."""
    least = depth(lines[index])
    for number in range(index - 1, -1, -1):
        said = lines[number].strip()
        if said and depth(lines[number]) < least:
            least = depth(lines[number])
            if said.startswith("try:") and _caught(lines, number + 1, least):
                return True
            if said.startswith("def "):
                return False
    return False


def _caught(lines: Sequence[str], start: int, least: int) -> bool:
    """Tell whether what follows on a ``try`` catches more than a module that is not there."""
    for number in range(start, len(lines)):
        said = lines[number].strip()
        if said and depth(lines[number]) <= least:
            if said.startswith("except") and not _WITHOUT_MODULE.match(said):
                return True
            if not said.startswith(("except", "else", "finally", "#")):
                return False
    return False
