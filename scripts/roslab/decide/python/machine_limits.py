"""Limits for what is guessed, from a list of what a whole machine with ROS, or an Anaconda, had installed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Choice
from roslab.decide.python.bounds import Constraints
from roslab.decide.python.machine_lists import of_machines
from roslab.decide.python.packages import Chosen
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import framework_on_cuda, released_together
from roslab.knowledge.guesses import same_module, tooling
from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.released import ever_released
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_MADE_BY_DEBIAN = "pkg-resources"
"""An entry that the Debian of then put into what ``pip freeze`` printed: https://bugs.debian.org/871790, 2026-11-27."""
_OF_ROS = pattern(r"(?:ros|rqt|gen|smc|qt|tf2?)[-_]|ros[a-z0-9]+$")
"""How most of ROS's own packages are called, those too that no distribution released by themselves."""
_WHY = "the author's machine had this release"


def machine_limits(evidence: Evidence, chosen: Chosen, asked: Iterable[Requirement]) -> Choice[Constraints]:
    """Return the releases of the one such list for what the guesses need, where nothing but guesses is installed.

    Not of what is ``asked`` for itself, by whichever name: that has its release, or none. Nor of ROS's own packages,
    which the index has not, nor of frameworks and what is released with them: theirs fit a Python and a CUDA.
    """
    lists = of_machines(evidence)
    if len(lists) != 1 or chosen.files or chosen.projects or chosen.declared or chosen.conda or not chosen.guessed:
        return Choice(answer=())
    names = {each.key for each in asked if each.name}
    limits = tuple(each for each in _entries(evidence, *lists) if not _taken(each.key, names))
    reasons = (because("dependencies", each.written, _WHY, each, weight=Weight.BOUND) for each in limits)
    return Choice(answer=limits, reasons=tuple(reasons))


def _entries(evidence: Evidence, path: str) -> Iterator[Requirement]:
    other = tooling("ros") | tooling("anaconda") | tooling("installers") | not_on_index().keys()
    other |= {name for names in released_together().values() for name in names} | {_MADE_BY_DEBIAN}
    listed = (asked for file in evidence.requirements if file.file == path for asked in file.requirements)
    for each in listed if not places.aside(path) else ():
        of_ros = _OF_ROS.match(each.key) or ever_released(each.key.replace("-", "_"))
        if each.release and not (each.url or of_ros or each.key in other or framework_on_cuda(each.key)):
            yield each


def _taken(name: str, names: set[str]) -> bool:
    return name in names or any(same_module(name, other) for other in names)
