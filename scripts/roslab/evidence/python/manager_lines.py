"""What a page has uv, Poetry, PDM or pixi install: ``uv sync --extra sim`` is like ``pip install .[sim]``.

https://docs.astral.sh/uv/reference/cli/#uv-sync, https://python-poetry.org/docs/cli/#install and
https://pdm-project.org/latest/reference/cli/#install, read 2026-11-26.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from roslab.evidence.lex.shell import UNKNOWN, Command
from roslab.knowledge.tools import PIXI
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement

GROUP = "group/"
"""What stands before the name of a dependency group among the extras of a project: the two have names of their own."""
EVERY = "*"
"""All extras."""


@dataclass(frozen=True, kw_only=True, slots=True)
class _Manager:
    """A manager: its verbs that install the project, and its options with names of extras, of groups, of both."""

    verbs: tuple[str, ...]
    extras: tuple[str, ...]
    groups: tuple[str, ...]
    every: tuple[str, ...]
    without: tuple[str, ...]
    """With one of these the project itself is not installed."""
    folder: tuple[str, ...]


_MANAGERS = {
    "uv": _Manager(
        verbs=("sync", "run"),
        extras=("--extra",),
        groups=("--group", "--only-group"),
        every=("--all-extras",),
        without=("--no-install-project", "--only-group", "--script", "--no-project"),
        folder=("--project", "--directory"),
    ),
    "poetry": _Manager(
        verbs=("install", "sync"),
        extras=("--extras", "-E"),
        groups=("--with", "--only"),
        every=("--all-extras",),
        without=("--no-root", "--only"),
        folder=("--project", "--directory", "-P", "-C"),
    ),
    "pdm": _Manager(
        verbs=("install", "sync"),
        extras=("--group", "-G", "--with"),
        groups=("--group", "-G", "--with"),
        every=(),
        without=("--no-self",),
        folder=("--project", "-p"),
    ),
}
_LONG = "--"


def manager_asks(command: Command, file: str, here: Callable[[str], str]) -> Iterator[Requirement]:
    """Yield the project that a manager installs, with its extras and groups in brackets as pip has extras.

    Of pixi it is the file that makes its environment. ``here`` makes a folder relative to the text's. What ``uv run``
    starts is not read: only what it installs first.
    """
    if command.words[0] == "pixi" and command.words[1:2] in {("run",), ("install",), ("shell",)}:
        yield Requirement(name="", written=PIXI, origin="prose", role="environment", file=file, line=command.line)
    manager = _MANAGERS.get(command.words[0].rpartition("/")[2])
    if manager is None or command.words[1:2] == () or command.words[1] not in manager.verbs:
        return
    folder, names = ".", list[str]()
    for option, value in _options(command.words[2:], manager):
        if option in manager.without:
            return
        if option in manager.folder:
            folder = value
        names += [each for each in value.replace(",", " ").split() if option in manager.extras]
        names += [GROUP + each for each in value.replace(",", " ").split() if option in manager.groups]
        names += [EVERY] if option in manager.every else []
    if command.words[1] == "run" and not names:
        return  # it says nothing that the project does not
    written = here(folder) + (f"[{','.join(names)}]" if names else "")
    if UNKNOWN not in written:
        by = command.words[0].rpartition("/")[2]
        yield Requirement(
            name="", written=written, origin="prose", role="project", group=by, file=file, line=command.line
        )


def _options(words: tuple[str, ...], manager: _Manager) -> Iterator[tuple[str, str]]:
    """Yield the options of a manager with their values, until the program that it starts; ``""`` where one has none."""
    valued = {*manager.extras, *manager.groups, *manager.folder}
    position = 0
    while position < len(words) and words[position].startswith("-"):
        option, _, glued = (
            words[position].partition("=") if words[position].startswith(_LONG) else (words[position], "", "")
        )
        position += 1
        value = glued
        if option in valued and not glued and position < len(words):
            value = words[position].strip("\"'")
            position += 1
        yield option, value
