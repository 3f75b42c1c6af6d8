"""The setuptools beside a package that is too old for newer ones: torch reads its own version through them."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Choice
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.knowledge.frameworks import old_setuptools
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version


def setuptools_of(asked: Iterable[Requirement]) -> Choice[Requirement | None]:
    """Return the setuptools of the environment, ``None`` where nothing limits it or its author does.

    It is no constraint: what pip builds apart from the environment may ask for a newer one.
    """
    names = {each.key: each for each in asked if each.name}
    if "setuptools" in names and names["setuptools"].limited:
        return Choice(answer=None)
    for name, before, line, why in old_setuptools():
        pinned = names.get(name)
        if pinned and pinned.release and Version(pinned.release) < Version(before):
            limit = stated(line, "table", pinned.file, pinned.line)
            reason = because("dependencies", line, f"{name} {pinned.release}: {why}", pinned, weight=Weight.BOUND)
            return Choice(answer=limit, reasons=(reason,))
    return Choice(answer=None)
