"""The folders of the tree that Python looks into: those of the author's pages, and the root where that is needed."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence

from roslab.config.model import Config, Kind
from roslab.decide.candidate import program_of
from roslab.decide.command import Command
from roslab.decide.python.image_python import Python
from roslab.decide.python.installed import installed
from roslab.decide.python_calls import modules_called
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.standard_modules import standard_modules


def python_path(evidence: Evidence, config: Config, kind: Kind, python: Python, command: Command) -> tuple[str, ...]:
    """Return the folders that belong on PYTHONPATH, each once; ROS and roslab.yaml have their own.

    The root, or ``src``, is one where the default ``command``, or a program that a page nearest to the root runs,
    imports what lies there and the image installs no project of the root; where only another one that is offered does,
    it must hide none of Python's own modules. Behind these come the folders of which such a program, or one that is
    offered, imports a module by its bare name, or a package that lies above it. None of what only an offered one needs
    has a module called like a package that the image installs. For Python 2, which looks beside the module that
    imports, only those above.
    """
    if config.compatible or kind not in {"python", "cuda"} or "PYTHONPATH" in dict(config.env):
        return ()
    said = tuple(dict.fromkeys(m.value for m in evidence.mentions if m.topic == "python_path"))
    if "." in python.projects:
        return said
    pages = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme"]
    nearest = min((m.file.count("/") for m in pages), default=0)
    commands = [m.value.split() for m in pages if m.file.count("/") == nearest]
    commands += [list(command.page.argv)] if command.page else []
    run = _programs(commands)
    default = list(command.page.argv) if command.page else _words(command.command)
    offered = run | _programs([*map(list, command.candidates), default])
    packages = {each.key.replace("-", "_") for each in installed(evidence, python)}
    from_root = [m for m in evidence.mentions if m.topic == "from_root" and m.file in offered]
    needed = [m.inside or "." for m in from_root if m.file in run]
    hides = packages | sys.stdlib_module_names | standard_modules()
    needed += [m.inside or "." for m in from_root if hides.isdisjoint(m.files)]
    above = [m.inside for m in _above(evidence, offered, _programs([default])) if packages.isdisjoint(m.files)]
    needed += [folder for folder in above if not _in_project(folder, python)]
    if (python.version or "").startswith("2"):
        return tuple(dict.fromkeys((*said, *needed)))
    needed += [
        f for f in _of_modules((default, *map(list, command.candidates)), evidence) if not _in_project(f, python)
    ]
    beside = [m for m in evidence.mentions if m.topic == "sibling_folder" and m.file in offered]
    needed += [m.inside for m in beside if packages.isdisjoint(m.files)]
    return tuple(dict.fromkeys((*said, *needed)))


def _above(evidence: Evidence, offered: set[str], default: set[str]) -> Iterator[Mention]:
    """Yield the folders above the programs that are offered, the default's first, none for a name that is had before.

    Of two folders with a package of one name the first hides the other: the default command decides.
    """
    found = [m for m in evidence.mentions if m.topic == "from_above" and m.file in offered]
    had: dict[str, str] = {}
    for mention in sorted(found, key=lambda m: m.file not in default):
        if had.setdefault(mention.value, mention.inside) == mention.inside:
            yield mention


def _of_modules(commands: Iterable[Sequence[str]], evidence: Evidence) -> Iterator[str]:
    """Yield the folder below the root that holds the package of a module which `python -m` starts by a dotted name."""
    for words in commands:
        option, name = [*program_of(tuple(words))[1:3], "", ""][:2] if words else ("", "")
        if option == "-m" and "." in name:
            found = modules_called(name, (each.file for each in evidence.programs))
            if len(found) == 1 and found[0][0]:
                yield found[0][0]


def _in_project(folder: str, python: Python) -> bool:
    """Tell whether a folder is of a project that the image installs: Python finds its packages then."""
    return places.innermost(folder, python.projects) is not None


def _programs(commands: Iterable[Sequence[str]]) -> set[str]:
    """Return the files of Python that commands start."""
    return {program[-1] for words in commands if words and (program := program_of(tuple(words)))[0] == "python3"}


def _words(command: tuple[str, ...] | str) -> list[str]:
    return command.split() if isinstance(command, str) else list(command)
