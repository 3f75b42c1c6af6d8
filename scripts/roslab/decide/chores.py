"""Calls that prepare a program or look after it: by its sub-commands (``app assets install``), or of another one."""

from __future__ import annotations

import itertools
import re
import shlex
from collections.abc import Iterable, Iterator

from roslab.decide.candidate import Candidate, is_python, program_of
from roslab.decide.decision import Warning_
from roslab.decide.reasons import page_of, warn
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_PREPARES = frozenset({"install", "download", "fetch", "setup", "init", "pull", "bootstrap"})
_LOOKS_AFTER = frozenset(
    {"check", "clean", "completion", "doctor", "help", "info", "list", "status", "uninstall", "update", "upgrade"}
    | {"validate", "verify", "version"}
)
_WORD = pattern(r"[A-Za-z][\w-]*")
_LAUNCHERS = frozenset({"roslaunch", "rosrun", "ros2", "make"})
_MAKES = pattern(
    r"(?:^|[_.-])(?:gen(?:erat[a-z]*)?|creat[a-z]*|collect[a-z]*|pre[_-]?proc[a-z]*|prepar[a-z]*|extract[a-z]*|"
    r"convert[a-z]*)(?:[_.-](?!(?:conda|v?env[a-z]*|docker[a-z]*|workspace|package)(?:[_.-]|$))|$)",
    re.IGNORECASE,
)
"""The name of a program of Python that makes what another one reads."""
MOST = 2
"""Sub-commands before the arguments: ``assets install``."""


def without_chores(written: Iterable[Candidate]) -> list[Candidate]:
    """Return the commands without such calls where the same page calls the same program otherwise too."""
    kept = list(written)
    meant = {(c.file, program_of(c.argv)) for c in kept if not _is_chore(c.argv)}
    return [c for c in kept if not _is_chore(c.argv) or (c.file, program_of(c.argv)) not in meant]


def prepared_before(page: Candidate, evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for each call before the default command with which the page prepares the same program."""
    for said in evidence.mentions:
        if said.topic == "command" and said.file == page.file and said.line < page.line:
            argv = tuple(said.value.split())
            if program_of(argv) == program_of(page.argv) and _subcommands(argv) & _PREPARES:
                message = (
                    f"{page_of(said.file)} runs `{shlex.join(argv)}` before the default command, and no build does"
                )
                yield warn(f"{message}: what it makes is missing; run it first, or by `custom` in roslab.yaml", said)


def made_before(page: Candidate, evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for the program that a section runs right before the default command to make something."""
    at = (page.file, page.heading)
    of_section = [
        each
        for each in evidence.mentions
        if each.topic == "command" and (each.file, each.heading) == at and each.line < page.line
    ]
    said = max(of_section, key=lambda each: each.line, default=None)
    program = next((file for file in said.files if file.endswith(".py")), "") if said else ""
    if said and is_python(page) and program not in {"", program_of(page.argv)[-1]} and _MAKES.search(_stem(program)):
        yield warn(
            f"{page_of(said.file)} runs `{said.value}` before the default command, and no build does: run it first, or "
            "by `custom` in roslab.yaml, where the tree lacks what it makes",
            said,
        )


def _stem(path: str) -> str:
    return path.rpartition("/")[2].removesuffix(".py")


def _is_chore(argv: tuple[str, ...]) -> bool:
    return bool(_subcommands(argv) & (_PREPARES | _LOOKS_AFTER))


def _subcommands(argv: tuple[str, ...]) -> set[str]:
    """Return the words behind a program up to its first option, the first two of them.

    Behind a file of Python they may be data as well (``sim.py check engine``): there one alone is a sub-command.
    """
    if argv[0] in _LAUNCHERS:
        return set()
    program = program_of(argv)
    arguments = argv[len(program) :]
    if program[-1].endswith(".py") and len(arguments) > 1:
        return set()
    return set(itertools.islice(itertools.takewhile(_WORD.fullmatch, arguments), MOST))
