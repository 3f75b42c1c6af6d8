"""The NumPy that packages of pip are compiled for, where an author has an older one than pip takes to build with.

pip builds each package in an environment of its own, with the newest NumPy of the Python unless a constraint says more.
What is compiled for NumPy 1.24 stops beside 1.19 (``module compiled against API version 0x10``); since NumPy 1.25 what
is compiled runs with older ones (https://numpy.org/doc/stable/dev/depending_on_numpy.html, read 2026-11-27). That one
needs Python 3.9, and pip for older Pythons hands ``PIP_CONSTRAINT`` on to where it builds (seen with pip 24.0).
"""

from __future__ import annotations

from collections.abc import Sequence

from roslab.decide.decision import Choice
from roslab.decide.python.bounds import Constraints, excluded
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.knowledge.compiled import prebuilt
from roslab.knowledge.frameworks import newest_framework
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version, minor_of

_COMPATIBLE = Version("3.9")
"""The first Python whose newest NumPy compiles for older ones."""
_LOWER = frozenset({">=", ">", "!="})


def numpy_of_builds(asked: Sequence[Requirement], python: str | None) -> Choice[Constraints]:
    """Return the author's own limit of NumPy as one for everything that pip builds; none where nothing may be compiled.

    ``asked``: what pip is asked for; ``python``: the image's.
    """
    if python is None or Version(python) >= _COMPATIBLE:
        return Choice(answer=())
    numpy = next((each for each in asked if each.key == "numpy" and each.limited and not each.url), None)
    compiled = next((each for each in asked if each.package and each.key not in {*prebuilt(), "numpy"}), None)
    limit = _limit(numpy) if numpy and not numpy.marker else None
    newest = newest_framework("numpy", python=minor_of(python))
    if not (numpy and compiled and limit and newest):
        return Choice(answer=())
    if limit.specifier.contains(newest.first) or excluded(limit, asked):
        return Choice(answer=())
    why = f"{compiled.written} may be compiled, and for a newer NumPy than {numpy.written} it does not load"
    place = numpy if numpy.file else None
    return Choice(answer=(limit,), reasons=(because("dependencies", limit.written, why, place, weight=Weight.BOUND),))


def _limit(numpy: Requirement) -> Requirement | None:
    """Return the upper end of what is asked for: what is built with an older one loads too."""
    upper = [each for each in numpy.specifier if each.operator not in _LOWER]
    exact = next((each.version for each in upper if each.operator == "==" and "*" not in each.version), None)
    parts = ",".join(sorted(f"{each.operator}{each.version}" for each in upper))
    return stated(f"numpy<={exact}" if exact else f"numpy{parts}") if upper else None
