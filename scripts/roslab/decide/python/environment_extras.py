"""The extras of guessed packages that the learning environments of the code need: ``gym[atari]``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set

from roslab.evidence.facts import Evidence
from roslab.knowledge.native_parts import series_of
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def for_environments(evidence: Evidence, guessed: Iterable[Requirement], known: Set[str]) -> Iterator[Requirement]:
    """Yield what a package among ``guessed`` needs beside itself for the games of Atari, of its own version.

    It is asked for on its own: where it cannot be had, the package alone is there. ``known``: what is installed anyway.
    """
    made = next((each for each in evidence.mentions if each.topic == "environment"), None)
    if made is None:
        return
    from roslab.knowledge.environment_extras import environment_extras  # noqa: PLC0415 - few trees make an environment

    guessed = tuple(guessed)
    named = {*known, *(each.key for each in guessed)}
    for each in guessed:
        row = None if each.extras or each.url else series_of(each, evidence.pip_day, environment_extras())
        for line in row.needs if row else ():
            asked = stated(line, "import", made.file, made.line)
            if asked.key == each.key:
                yield stated(f"{line}{each.specifier}", "import", made.file, made.line)
            elif asked.key not in named:
                yield asked
