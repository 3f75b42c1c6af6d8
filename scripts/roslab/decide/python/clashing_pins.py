"""Pins of a list beside which another pin of it does not work, though that one does not say so: a bot raised one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.python.beside_nodes import Loose
from roslab.decide.python.bounds import excluded
from roslab.decide.python.undeclared import decide_undeclared, older
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.knowledge.undeclared_limits import UndeclaredLimit, undeclared_limits
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def clashing_pins(evidence: Evidence, python: str | None) -> Loose:
    """Return the pins that give way to what another line of their list or project needs, each with what is told.

    What needs it stops beside the pin, whoever wrote it. Only where the image's ``python`` has releases that fit, by
    which the package is limited in its place, and no other line needs a newer one.
    """
    found: dict[Requirement, Warning_] = {}
    for asked in _together(evidence):
        for known, each in _needs(asked).items():
            pins = [
                pin for pin in asked if pin.key == known.limit.key and pin.release and excluded(known.limit, (pin,))
            ]
            if not pins or not _fits(known, each, pins, asked, python):
                continue
            place = f" ({each.file}:{each.line})" if each.file else ""
            for pin in pins:
                why = f"{each.written}{place} needs that but does not say so, and stops beside {pin.written}"
                found.setdefault(pin, warn(f"{pin.written} gives way to {known.limit.written}: {why}", pin))
    return found


def _together(evidence: Evidence) -> Iterator[list[Requirement]]:
    """Yield what each list and each project asks for on every Python, where a table knows something of it."""
    lists = (file.requirements for file in evidence.requirements)
    for asked in (*lists, *(project.requirements for project in evidence.python)):
        plain = [each for each in asked if each.name and not each.url and not each.marker]
        if any(each.key in undeclared_limits() for each in plain):
            yield plain


def _needs(asked: Iterable[Requirement]) -> dict[UndeclaredLimit, Requirement]:
    """Return the limits of what is asked for, each with the first line that needs it."""
    found: dict[UndeclaredLimit, Requirement] = {}
    for each in asked:
        for known in undeclared_limits().get(each.key, ()):
            if older(each, known):
                found.setdefault(known, each)
    return found


def _fits(
    known: UndeclaredLimit, each: Requirement, pins: list[Requirement], asked: list[Requirement], python: str | None
) -> bool:
    """Tell whether the package is limited for the line that needs it, where the pins are free, beside the others."""
    free = stated(pins[0].name or pins[0].key, pins[0].origin, pins[0].file, pins[0].line)
    gone = {*pins}
    others = (line for line in asked if line not in gone and line.key != each.key)
    return known.limit in decide_undeclared((each, free, *others), python=python).answer.pip
