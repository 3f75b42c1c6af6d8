"""Which Python version the repository runs with."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import groupby

from roslab.config.model import Config
from roslab.decide.decision import Choice, Reason
from roslab.decide.python.last_releases import ranges_of_lists
from roslab.decide.python.of_sources import ranges_of_sources
from roslab.decide.python.pins import Pin
from roslab.decide.python.pythons import DEFAULT, PREFERRED
from roslab.decide.python.ranges import (
    Range,
    only_lowest,
    only_oldest,
    ranges,
    ranges_at_least,
    ranges_by_syntax,
    ranges_by_use,
    ranges_left,
    recommended,
)
from roslab.decide.python.requires import able, required
from roslab.decide.python.weights import VersionWeight as Weight
from roslab.decide.reasons import because, configured, outweighed
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.python import version_file
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.days import existed, usual
from roslab.knowledge.distros import python_of_ubuntu, ubuntus
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern
from roslab.values.version import Version, version_of

_OLDEST = Version("2.7")
_UBUNTU = pattern(r"(?:^|/|-)ubuntu:?(\d\d\.04)")
_BOTH = pattern(
    r"python\s*3|\b3\.\d|as well as|\bstill\b|or (?:later|newer|above)|\balso\b|\+|≥|>="
    r"|\bdrop(?:s|ped|ping)?\b|no longer|deprecat|end[- ]of[- ]life",
    re.IGNORECASE,
)
"""A sentence about Python 2 that allows Python 3 as well."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Wanted:
    """The Python that the repository asks for."""

    version: str | None
    """``3.8``; ``None`` if it says nothing about Python."""
    fitting: tuple[str, ...] = ()
    """Those that fit all it says, where nothing names one."""


def python_version(
    evidence: Evidence,
    config: Config,
    pins: tuple[Pin, ...],
    projects: Iterable[PythonProject] = (),
    made: str | None = None,
) -> Choice[Wanted]:
    """Return the Python that the repository asks for, and why.

    One on which pip refuses the project at the root or one of ``projects`` is not taken, whatever names it, but for the
    conda environment ``made``.
    """
    if config.base.python:
        own = configured(config, "python", config.base.python, "base.python")
        return Choice(answer=Wanted(version=config.base.python), reasons=(own,))
    known = (
        *ranges(evidence, pins, _telling(evidence)),
        *ranges_of_sources(evidence),
        *ranges_at_least(evidence),
        *ranges_left(evidence),
    )
    said = sorted(_named(evidence, pins), key=_order)
    named = able(said, required(evidence, projects), made)
    if known or named:  # syntax alone tells nothing of the version that is meant
        meant = {*_fitting(known)} if known else {each.answer for each in named}
        known = (*known, *(each for each in ranges_by_syntax(evidence) if not meant <= each.pythons))
    fitting = [python for python in _fitting(known) if evidence.day is None or existed(python, evidence.day)]
    chosen = next((reason for reason in named if reason.answer in fitting or reason.weight >= Weight.BELIEVED), None)
    if chosen is None and (older := tuple(ranges_by_use(evidence, pins))):  # nothing names a version
        known = (*known, *older)
        fitting = [python for python in fitting if all(python in each.pythons for each in older)] or fitting
    for each in ranges_of_lists(pins) if chosen is None and fitting else ():
        if narrower := [python for python in fitting if python in each.pythons]:
            known, fitting = (*known, each), narrower
    if day := evidence.pip_day:  # its packages had wheels for no newer Python
        fitting = [python for python in fitting if usual(python, day)] or fitting
    reasons = [each.reason for each in known]
    if chosen is not None:
        others = (reason for reason in (*said, *reasons) if reason is not chosen)
        return Choice(answer=Wanted(version=chosen.answer), reasons=(chosen, *outweighed(others, chosen)))
    fitting = _unread(fitting, pins)
    if not known or not fitting:
        return Choice(answer=Wanted(version=None), reasons=tuple(replace(reason, decisive=False) for reason in said))
    every = all(fitting[0] in each.pythons for each in known)
    why = "fits every pin below" if every else "fits most of the pins below, which contradict each other"
    fits = because("python", fitting[0], why, weight=Weight.PINS)
    passed = outweighed((reason for reason in said if reason not in named), fits)
    return Choice(answer=Wanted(version=fits.answer, fitting=tuple(fitting)), reasons=(fits, *reasons, *passed))


def read_by(evidence: Evidence, default: str) -> Choice[Wanted] | None:
    """Return the preferred Python that has what the code uses, ``None`` where the ``default`` has it, too."""
    known = tuple(ranges_by_syntax(evidence))
    lacking = [each for each in known if default not in each.pythons]
    if not lacking:
        return None
    fitting = _fitting(known)
    if day := evidence.day:
        fitting = [python for python in fitting if existed(python, day)] or fitting
    if day := evidence.pip_day:
        then = [python for python in fitting if existed(python, day)]
        fitting = [python for python in then if usual(python, day)] or then or fitting
    why = f"nothing names a version, and {lacking[0].reason.reason}, which Python {default} does not have"
    chosen = because("python", fitting[0], why, lacking[0].reason, weight=Weight.USED)
    others = (each.reason for each in known if each is not lacking[0])
    return Choice(answer=Wanted(version=fitting[0], fitting=tuple(fitting)), reasons=(chosen, *others))


def _fitting(known: tuple[Range, ...]) -> list[str]:
    """Return the Pythons that fit all ranges; one that contradicts those before it, the more trusted, is left out.

    Of pins that are trusted alike those count that most agree on: robots raise single lines of old lists.
    """
    fitting = list(PREFERRED)
    for trust, alike in groupby(known, key=lambda each: each.trust):
        group = tuple(alike)
        if trust is not None:
            fits = {python: sum(python in each.pythons for each in group) for python in fitting}
            fitting = [python for python in fitting if fits[python] == max(fits.values())]
        for each in group:
            fitting = [python for python in fitting if python in each.pythons] or fitting
    return fitting


def _unread(fitting: list[str], pins: Iterable[Pin]) -> list[str]:
    """Return the Pythons that fit, the oldest from the default on first where all are newer and git brings a package.

    What that pins is not read here, and may have no wheels for a Python that came after it; the author's has them.
    """
    newer = fitting and Version(fitting[0]) > Version(DEFAULT) and DEFAULT not in fitting
    if not newer or not any(pin.trust and pin.requirement.vcs for pin in pins):
        return fitting
    above = [python for python in fitting if Version(python) > Version(DEFAULT)]
    oldest = min(above, key=Version)
    return [oldest, *(python for python in fitting if python != oldest)]


def _order(reason: Reason) -> tuple[int, str, int, list[int]]:
    """Return the sort key of a written version: by weight, then by place, on one line the newest first."""
    return -reason.weight, reason.file or "", reason.line or 0, [-number for number in Version(reason.answer).release]


def _named(evidence: Evidence, pins: Iterable[Pin]) -> Iterator[Reason]:
    """Yield the versions that are written down."""
    for environment in evidence.conda:
        if environment.python and not places.vendored(environment.file):
            weight = Weight.CONDA.get(environment.file.count("/"), Weight.CONDA_DEEP)
            yield because("python", environment.python, "the conda environment has it", environment, weight=weight)
    three = any("Python :: 3" in line for p in evidence.python if not p.folder for line in p.classifiers)
    for mention in evidence.mentions:
        number = version_of(mention.value) if mention.topic == "python" else None
        if number and number >= _OLDEST and not only_oldest(evidence, mention):
            yield from _mentioned(mention, three=three)
        elif mention.topic == "compiled_for":
            why = f"{mention.text}, which the tree has, is compiled for it"
            yield because("python", mention.value, why, mention, weight=Weight.WHEEL)
    yield from _of_images(evidence)
    for pin in pins:
        if pin.trust and pin.requirement.wheel and (python := pin.requirement.wheel.python):
            yield because("python", python, "a wheel for it is named", pin.requirement, weight=Weight.WHEEL)


def _mentioned(mention: Mention, *, three: bool) -> Iterator[Reason]:
    """Yield a version that a page or the code names; ``three``: the project's classifiers have Python 3."""
    if mention.source == "code":
        why = "print is a statement in most of its modules"
        yield because("python", mention.value, why, mention, weight=0 if three else Weight.PRINT_STATEMENT)
        return
    if mention.value.startswith("2") and (three or _BOTH.search(mention.text)):
        return  # Python 3 works as well
    if mention.file == version_file.NAME:
        why = f"{mention.file} names it"
        yield because("python", mention.value, why, mention, weight=Weight.VERSION_FILE)
        return
    weight = Weight.SAID.get(mention.source, Weight.SAID_ELSEWHERE)
    weight -= Weight.DEEPER * min(mention.file.count("/"), 3)
    weight += Weight.CREATES if "create" in mention.text and "python" in mention.text else 0
    weight -= Weight.AT_LEAST if only_lowest(mention) else 0
    weight += Weight.RECOMMENDED if recommended(mention) else 0
    yield because("python", mention.value, f"“{mention.text[:80]}”", mention, weight=weight)


def _telling(evidence: Evidence) -> set[str]:
    """Return the Dockerfiles that name the Python they are for."""
    return {m.file for m in evidence.mentions if m.topic == "python" and m.source == "dockerfile"}


def _of_images(evidence: Evidence) -> Iterator[Reason]:
    """Yield the Python of a Dockerfile's Ubuntu, if it installs packages and names no Python."""
    telling = _telling(evidence)
    for authored in evidence.dockerfiles:
        if authored.purpose != "project" or authored.file in telling:
            continue
        tag = _UBUNTU.search(authored.base or "")
        number = python_of_ubuntu().get(ubuntus().get(tag[1], "")) if tag else None
        if number and authored.requirements:
            why = f"the Python of {authored.base}"
            weight = Weight.IMAGE - Weight.DEEPER * min(authored.file.count("/"), 3)
            yield replace(because("python", number, why, authored, weight=weight), line=authored.base_line)
