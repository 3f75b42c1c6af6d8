"""Pins and lower bounds that no release for the image's Python meets: single lines; the others need that Python."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.frameworks import framework
from roslab.values.dataclass import replace
from roslab.values.interpreter import Interpreter
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version


def too_new(asked: Requirement, python: str | None) -> bool:
    """Tell whether a requirement is pinned to a release whose first Python is newer than this one, or begins there.

    Robots that raise single lines of old lists leave such pins, and lists that were written on another machine such
    bounds: pip finds no release for them and stops.
    """
    release = _lowest(asked)
    if python is None or release is None or not Interpreter(pythons=(python,)).may(asked):
        return False
    row = framework(asked.key, release)
    return row is not None and Version(python) < Version(row.python_min)


def _lowest(asked: Requirement) -> str | None:
    return None if asked.url or not asked.name else asked.release or asked.at_least


def loosened(
    found: Iterable[Requirement], python: str | None, also: Container[Requirement] = ()
) -> Iterator[Requirement]:
    """Yield the requirements, those without their version that are too new for the Python, and ``also`` these."""
    for asked in found:
        if asked in also or too_new(asked, python):
            free = stated(asked.name or asked.key, asked.origin, asked.file, asked.line)
            yield replace(free, marker=asked.marker, extras=asked.extras, role=asked.role)
        else:
            yield asked


def told(asked: Requirement, python: str | None) -> Warning_:
    """Return the warning about one of them."""
    row = framework(asked.key, _lowest(asked) or "")
    needs = row.python_min if row else "a newer one"
    message = f"{asked.written} needs Python {needs}, and the image has {python}"
    return warn(f"{message}: pip takes a release of {asked.name} that runs there", asked)
