"""Steps of an author's Dockerfile, and of scripts that it runs, that start every compiler at once: ``make -j``.

https://www.gnu.org/software/make/manual/html_node/Parallel.html, read 2026-11-28: without a number nothing limits
it but a load (``-l``), and MAKEFLAGS of the environment sets none where the command line has its own ``-j``. Ninja
bounds itself.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import AuthorDockerfile, Mention
from roslab.evidence.lex.dockerfile import instructions
from roslab.evidence.lex.shell import UNKNOWN, Command, commands, logical_lines
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_MAKE = frozenset({"make", "gmake", "catkin_make"})
_JOBS = ("-j", "--jobs", "--parallel")
_LOAD = ("-l", "--load-average", "--max-load")
_NINJA = pattern(r"\bninja\b", re.IGNORECASE)
"""What CMake calls may be that."""
_SCRIPT = pattern(r"[\w.+-]+\.(?:sh|bash)\b")
_NUMBER = pattern(rf"[\d$`{UNKNOWN}]")
"""How what bounds them begins: what a shell puts there is a number as well."""


def read(repository: Repository, dockerfiles: Iterable[AuthorDockerfile]) -> Iterator[Mention]:
    """Yield each such call, ``inside`` of the Dockerfile whose build it may end."""
    for authored in dockerfiles:
        if authored.purpose != "project":
            continue
        text = repository.read(authored.file, limit=MAX_SIZE)
        by_cmake = _NINJA.search(text) is None
        steps = [step for step in instructions(text) if step.name == "RUN"]
        for step in steps:
            yield from _calls(step.text, step.line, authored.file, authored.file, by_cmake=by_cmake)
        for name in sorted({match[0] for step in steps for match in _SCRIPT.finditer(step.text)}):
            files = repository.named(name)
            if len(files) == 1:
                script = repository.read(files[0], limit=MAX_SIZE)
                yield from _calls(
                    script, 1, files[0].path, authored.file, by_cmake=by_cmake and not _NINJA.search(script)
                )


def _calls(text: str, line: int, file: str, inside: str, *, by_cmake: bool) -> Iterator[Mention]:
    for start, logical in logical_lines(text, line):
        for command in commands(logical, start):
            if _unbounded(command) and (by_cmake or command.words[0] != "cmake"):
                said = " ".join(command.words).replace(UNKNOWN, "…")[:200]
                yield Mention(
                    topic="unbounded",
                    value=inside,
                    source="dockerfile",
                    file=file,
                    line=command.line,
                    text=said,
                    inside=inside,
                )


def _unbounded(command: Command) -> bool:
    """Tell whether a command has make start as many compilers as there are files."""
    words = command.words
    if words[0].rpartition("/")[2] not in _MAKE and words[:2] != ("cmake", "--build"):
        return False
    last = next((n for n in range(len(words) - 1, 0, -1) if words[n].startswith(_JOBS)), 0)
    after = words[last + 1 : last + 2]
    loaded = any(word.startswith(_LOAD) for word in words)
    return words[last] in _JOBS and not loaded and not (after and _NUMBER.match(after[0]))
