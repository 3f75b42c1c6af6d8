"""Recognises the format of a roslab.yaml, and which line belongs to which format in a file that mixes them.

``format: 3`` marks today's format; ``distro`` (or another key that only the 2019 paper's format has) the paper's;
``base.system`` the interim one. Everything else is the later old format, in which today's keys are allowed too.
"""

from __future__ import annotations

from roslab.config import vocabulary
from roslab.config.model import Generation
from roslab.config.node import Mapping, in_file
from roslab.errors import ConfigurationError, Problem
from roslab.values.origin import Place

NAMES: dict[Generation, str] = {
    "paper": "the 2019 paper's format",
    "interim": "the interim format (repolab)",
    "later": "the later old format",
    "today": "today's format (`format: 3`)",
}
_ENOUGH = 2
"""A file with this many keys of another program of that name is taken for a file of that program."""


def keys(generation: Generation) -> frozenset[str]:
    """Return the top-level keys of a format."""
    return frozenset(vocabulary.definition(generation)["properties"])


def news() -> frozenset[str]:
    """Return the keys that are new today: no old generator knew them, but the old formats may use them too."""
    return keys("today") & keys("later") & keys("paper") - {"name", "build", "volume", "custom", "source"}


def own(generation: Generation) -> frozenset[str]:
    """Return the keys by which an old format is recognised."""
    others: tuple[Generation, ...] = ("paper", "later") if generation == "interim" else ("interim", "later")
    if generation == "later":
        others = ("paper",)
    found = keys(generation)
    for other in others:
        found -= keys(other)
    return found - {"format"}


def tell(root: Mapping, *, file: str) -> Generation:
    """Return the format of a file.

    Raises ``ConfigurationError`` if the file belongs to another program and only has the same name.
    """
    names = set(root.names)
    foreign = [name for name in root.names if name in vocabulary.rows("foreign")]
    if "roslab_version" in foreign or (len(foreign) >= _ENOUGH and "base" not in names):
        key = root.key(foreign[0])
        raise ConfigurationError(
            Problem(
                message=f"this file is of the ROS code generator also called roslab: it has {', '.join(foreign)}",
                hint="leave it to that program, and give this one a file of another name (`config`), or none at all",
                origin=in_file(file)(key.start) if key else Place(file=file),
            )
        )
    if "format" in names:
        return "today"
    base = root.get("base")
    if isinstance(base, Mapping) and "system" in base.names:
        return "interim"
    if "base" in names:
        return "later"
    if "distro" in names or (names & own("paper") and not names & own("later")):
        return "paper"
    return "later"


def rivals(root: Mapping, generation: Generation) -> tuple[str, ...]:
    """Return the keys of the 2019 paper's format that occur in a file of another format."""
    if generation == "paper" or "distro" not in root.names:
        return ()
    return tuple(name for name in root.names if name in own("paper"))


def mixture(root: Mapping, generation: Generation, *, file: str) -> Problem | None:
    """Return a problem that lists the lines of each format if a file mixes two, otherwise ``None``."""
    strange = rivals(root, generation)
    if not strange:
        return None
    mine = own(generation) | {"base", "format"} & keys(generation)
    ours = ", ".join(_line(root, name) for name in root.names if name in mine)
    theirs = ", ".join(_line(root, name) for name in strange)
    told = f"{NAMES[generation]}: {ours}; {NAMES['paper']}: {theirs}"
    first = root.key(strange[0])
    return Problem(
        message=f"the keys of two formats stand in one file: {told}",
        hint=f"keep those of {NAMES[generation]} and take the others out",
        origin=in_file(file)(first.start) if first else Place(file=file),
    )


def elsewhere(generation: Generation, name: str) -> str | None:
    """Return which format an unknown key belongs to and what to write instead; ``None`` if no format has it."""
    order: tuple[Generation, ...] = ("paper", "interim", "later", "today")
    homes = [NAMES[other] for other in order if other != generation and name in keys(other)]
    if not homes:
        return None
    translations = vocabulary.rows("translations")
    if generation in {"paper", "interim"}:
        word = next((old for old, new in translations.items() if new == name and old in keys(generation)), None)
    else:
        word = translations.get(name)
        if generation == "today" and word == "pip":
            word = "pip2"  # what `pip` meant before
    instead = f"did you mean `{word}`? " if word else ""
    return f"{instead}`{name}` is a word of {homes[0]}, this file is in {NAMES[generation]}"


def _line(root: Mapping, name: str) -> str:
    key = root.key(name)
    return f"`{name}` (line {key.start.line})" if key else name
