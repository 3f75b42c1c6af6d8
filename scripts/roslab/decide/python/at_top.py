"""What the default command cannot start without, of the packages that are only tried."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.candidate import Candidate, program_of
from roslab.decide.command import Command
from roslab.decide.python.command_imports import CommandImports
from roslab.decide.python.on_index import with_one_word_more
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import same_module
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement

_SENTENCES = frozenset({"listed", "bounded"})


def imported_by_command(evidence: Evidence, command: Command, guessed: Iterable[Requirement]) -> CommandImports:
    """Return the modules of guesses that the command's files import at their top.

    Their packages are tried, as all that no manifest names; a guess is left out where pip cannot install it, and the
    command then stops at the import.
    """
    guessed = tuple(guessed)
    required = tuple(_required(evidence, command.page, guessed))
    programs = {*started_files(command.page.argv if command.page else command.command, evidence)}
    names = {each.key for each in guessed} if programs else set()
    found = (each.value for each in evidence.mentions if each.topic == "start_import" and each.inside in programs)
    tried = (module for module in dict.fromkeys(found) if module not in required and _tried(module, names))
    caught = tuple(each.value for each in evidence.mentions if each.topic == "caught_import")
    return CommandImports(required=required, tried=tuple(tried), caught=caught)


def _required(evidence: Evidence, command: Candidate | None, guessed: Iterable[Requirement]) -> Iterator[str]:
    """Yield the modules that the command's own file imports at its top and that lines of the README install."""
    started = {word for word in command.argv if word.endswith(".py")} if command else set()
    asked = [each for each in guessed if _of_readme(each)] if started else []
    written = {each.key for each in asked}
    written |= {canonicalize_name(each.url.partition("#subdirectory=")[2]) for each in asked}
    said = (mention.value for mention in evidence.mentions if mention.topic == "at_top" and mention.file in started)
    yield from (module for module in said if _brought(module, written))


def started_files(argv: tuple[str, ...] | str, evidence: Evidence) -> Iterator[str]:
    """Yield the files of the tree that a command may start with Python; a shell script starts what it first calls.

    ``-m a.b`` is ``a/b.py`` or ``a/b/__main__.py``.
    """
    if isinstance(argv, str) or not argv:
        return
    start, *words = program_of(argv)
    if start.startswith("python") and words[:1] == ["-m"]:
        path = words[-1].replace(".", "/")
        yield from (f"{path}.py", f"{path}/__main__.py")
    elif start.startswith("python"):
        yield from words
    for said in evidence.mentions if start in {"bash", "sh"} else ():
        if said.topic == "runs" and said.value in argv:
            yield from (file for file in said.files if file.endswith(".py"))


def _tried(module: str, names: set[str]) -> bool:
    return _brought(module, names) or any(with_one_word_more(module, name) for name in names)


def _of_readme(asked: Requirement) -> bool:
    return asked.origin == "prose" and asked.role not in _SENTENCES and asked.file.lower().startswith("readme")


def _brought(module: str, names: set[str]) -> bool:
    package, _ = imports().get(module) or (None, None)
    name = canonicalize_name(package or module)
    return name in names or any(same_module(name, other) for other in names)
