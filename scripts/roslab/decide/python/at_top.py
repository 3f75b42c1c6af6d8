"""What the default command cannot start without, of the packages that are only tried."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.candidate import Candidate
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import same_module
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement

_SENTENCES = frozenset({"listed", "bounded"})


def imported_by_command(
    evidence: Evidence, command: Candidate | None, guessed: Iterable[Requirement]
) -> tuple[str, ...]:
    """Return the modules that the command's own file imports at its top and that lines of the README install.

    Their packages are tried, as all that only a page names; an image without one of them cannot run its command.
    """
    started = {word for word in command.argv if word.endswith(".py")} if command else set()
    asked = [each for each in guessed if _of_readme(each)] if started else []
    written = {each.key for each in asked}
    written |= {canonicalize_name(each.url.partition("#subdirectory=")[2]) for each in asked}
    said = (mention.value for mention in evidence.mentions if mention.topic == "at_top" and mention.file in started)
    return tuple(module for module in said if _brought(module, written))


def _of_readme(asked: Requirement) -> bool:
    return asked.origin == "prose" and asked.role not in _SENTENCES and asked.file.lower().startswith("readme")


def _brought(module: str, names: set[str]) -> bool:
    package, _ = imports().get(module) or (None, None)
    name = canonicalize_name(package or module)
    return name in names or any(same_module(name, other) for other in names)
