"""What a Makefile at the root gives CMake, where an author calls that by it: ``cmake -DTASK=demo . -Bbuild``.

Variables have the values that the Makefile sets them to; where it sets one to several, nobody knows which.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_NAMES = ("GNUmakefile", "makefile", "Makefile")
_SET = pattern(r"^(?:export[ \t]+)?(\w+)[ \t]*[:?]?=[ \t]*([^#\n]{0,200})", re.MULTILINE)
_CALLS = pattern(r"\bcmake\s")
_USED = pattern(r"\$[({](\w+)[)}]")
_OPTION = pattern(r"-D(?!CMAKE_)[A-Za-z_]\w*(?::[A-Z]+)?=[\w.+-]+")
"""One without a path: no folder of the author's machine."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first call that configures the root: ``text`` has its options, each a word."""
    file = next((file for name in _NAMES for file in repository.named(name) if not file.folder), None)
    if file is None or file.size > MAX_SIZE or not repository.has("CMakeLists.txt"):
        return
    text = repository.read(file)
    if not _CALLS.search(text):
        return
    from roslab.evidence.lex.shell import logical_lines  # noqa: PLC0415 - few Makefiles call CMake
    from roslab.evidence.prose.configured import of_another  # noqa: PLC0415 - as above
    from roslab.evidence.prose.installs import Collector  # noqa: PLC0415 - as above

    values: dict[str, set[str]] = {"CURDIR": {"."}, "PWD": {"."}}
    for name, value in _SET.findall(text):
        values.setdefault(name, set()).add(value.strip())
    for number, line in logical_lines(text):
        if line.startswith("\t") and _CALLS.search(line):
            collector = Collector(file.path, "script")
            collector.text(_filled(line.replace("\n", " ").strip().lstrip("@-+"), values), number)
            for said in collector.mentions:
                here = said.topic == "compiled" and said.value == "." and not collector.below.strip("./")
                if here and not of_another(said, repository):
                    options = " ".join(word for word in said.text.split() if _OPTION.fullmatch(word))
                    yield replace(said, text=options)
                    return


def _filled(line: str, values: dict[str, set[str]]) -> str:
    """Return a line with the value of each variable that has one; values may name others in turn."""

    def value(match: re.Match[str]) -> str:
        said = values.get(match[1], set())
        return next(iter(said)) if len(said) == 1 else match[0]

    return _USED.sub(value, _USED.sub(value, line))
