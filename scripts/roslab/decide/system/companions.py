"""What CMake requires and only a source of apt may have from which other packages of the image are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.names import APT_NAME, Target, resolve
from roslab.decide.system.needs import code_needs
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.apt_sources import folder_of_package
from roslab.knowledge.distros import python_of_ubuntu
from roslab.values.dataclass import replace

if TYPE_CHECKING:
    from roslab.decide.system.packages import SystemPackages

WEIGHT = 90
"""Packages do not compete, so it only orders the report."""


def with_companions(
    choice: Choice[SystemPackages], evidence: Evidence, packages: Packages, target: Target
) -> Choice[SystemPackages]:
    """Guess the packages of such a source that are called as what is required and nothing known brings.

    Its packages bring one another: ``robotpkg-py38-pinocchio`` comes with ``robotpkg-py38-eigenpy``.
    """
    beginnings = {name.partition("-")[0] for name in choice.answer.installed if folder_of_package(name)}
    if not beginnings:
        return choice
    found: dict[str, Dependency] = {}
    for asked in code_needs(evidence, packages):
        meant = resolve(asked, target)
        if asked.namespace == "cmake" and asked.strength == "declared" and not (meant.apt or meant.recipe):
            names = [name for name in _called(asked.name, beginnings, target) if APT_NAME.match(name)]
            found |= dict.fromkeys(names, asked) if {*names}.isdisjoint(choice.answer.installed) else {}
    why = "{} is required, and the source of others may have it"
    reasons = (
        because("dependencies", name, why.format(asked.name), asked, weight=WEIGHT) for name, asked in found.items()
    )
    answer = replace(choice.answer, apt_guessed=tuple(sorted({*choice.answer.apt_guessed, *found})))
    return replace(choice, answer=answer, reasons=(*choice.reasons, *reasons))


def _called(name: str, beginnings: Iterable[str], target: Target) -> Iterator[str]:
    plain = name.lower().replace("_", "-")
    python = python_of_ubuntu().get(target.ubuntu or "", "").replace(".", "")
    for begin in sorted(beginnings):
        yield f"{begin}-{plain}"
        if python:
            yield f"{begin}-py{python}-{plain}"
