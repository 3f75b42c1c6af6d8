"""Launch files whose name has a blank on a page, ``mapping_XXX.launch``, ``mapping_[sensor].launch``.

Any of those that fit is meant. Where the whole name is a blank, ``[launch-file]``, it is the first that the section
names above: in a table, for one.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from roslab.evidence.facts import Evidence, Mention
from roslab.values.numbered import numbered
from roslab.values.pattern import pattern

_BLANK = pattern(
    r"\[[A-Za-z][\w -]{0,40}\]|<>|…|\{[A-Za-z][\w -]{0,40}\}|[xX]{2,}|(?<![A-Za-z])[A-Z]{3,}(?:_[A-Z]+)*(?![A-Za-z])"
)
LAUNCH = pattern(r"\.launch(?:\.(?:py|xml|ya?ml))?$|_launch\.(?:py|xml|ya?ml)$")
"""How the name of a launch file ends."""


MOST = 3
"""Most blanks of a name: with each one more, far more ways to fill them in are tried."""
BLANK = "<>"
"""What stands for a blank of a page in brackets, which the reader fills in."""
_BLANKS = frozenset({BLANK, "…"})


def pointed_launches(evidence: Evidence) -> tuple[tuple[Mention, str, str], ...]:
    """Return the launch files that pages name in their sentences, each with its package and its name.

    One that is to be filled in is an example for the reader's own.
    """
    packages = {launch.file: launch.package for launch in evidence.launch if launch.package and not launch.to_fill}
    said = [mention for mention in evidence.mentions if mention.topic == "pointed" and mention.value in packages]
    return tuple((mention, packages[mention.value] or "", mention.value.rpartition("/")[2]) for mention in said)


def with_the_one_named(
    argv: tuple[str, ...], said: Mention, pointed: Iterable[tuple[Mention, str, str]]
) -> tuple[str, ...]:
    """Return a command whose launch file is a blank with the first of its package that its section names above it.

    Of a name with a blank in it, it is the first one that fits.

    ``pointed`` are launch files that pages name, as ``pointed_launches`` returns them.
    """
    at = _place(argv)
    if not at or len(argv) <= at or not (argv[at] in _BLANKS or _BLANK.search(argv[at])):
        return argv
    meant = None if argv[at] in _BLANKS else _meant(argv[at])
    for mention, package, name in sorted(pointed, key=lambda each: each[0].line):
        here = mention.file == said.file and mention.line < said.line and mention.heading == said.heading
        if here and package == argv[at - 1] and (argv[at] in _BLANKS or (meant and meant.fullmatch(name))):
            return (*argv[:at], name, *argv[at + 1 :])
    return argv


def with_a_launch_file(argv: tuple[str, ...], launched: Mapping[str, frozenset[str]]) -> tuple[str, ...]:
    """Return a command with the first launch file, by its name, that fits the blank in it; others as they are.

    ``launched`` are the launch files of each package. What is left of the name without the blank has to tell something.
    A name without its last ending gets that of the only file that is called so; one letter may stand for a number, of
    which the lowest is taken: ``demox.launch``.
    """
    at = _place(argv)
    if not at or len(argv) <= at or argv[at] in (names := launched.get(argv[at - 1], frozenset())):
        return argv
    if LAUNCH.search(argv[at]) and (whole := [name for name in names if name in _endings(argv[at])]):
        return (*argv[:at], *whole, *argv[at + 1 :]) if len(whole) == 1 else argv
    if number := numbered(argv[at], names):
        return (*argv[:at], number, *argv[at + 1 :])
    meant = _meant(argv[at])
    fitting = sorted(name for name in names if meant and meant.fullmatch(name))
    return (*argv[:at], fitting[0], *argv[at + 1 :]) if fitting else argv


def _meant(written: str) -> re.Pattern[str] | None:
    """Return what fits the blank in a name, ``None`` where none is in it or nothing is left to tell by."""
    said = LAUNCH.sub("", written)
    parts = _BLANK.split(said)
    if not 1 < len(parts) <= MOST + 1 or not any(part.strip("_-.") for part in parts):
        return None
    return re.compile(r"\w+".join(map(re.escape, parts)) + re.escape(written[len(said) :]))


def _endings(name: str) -> tuple[str, ...]:
    """Return the names that a page may have shortened: ``map.launch`` for ``map.launch.py``."""
    return tuple(f"{name}{ending}" for ending in (".py", ".xml", ".yaml", ".yml"))


def _place(argv: tuple[str, ...]) -> int:
    """Return which word of a command is the launch file of a package, 0 for none."""
    return 2 if argv[:1] == ("roslaunch",) else 3 if argv[:2] == ("ros2", "launch") else 0
