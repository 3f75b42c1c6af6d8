"""Which Pythons fit the repository's declarations, its pinned packages and its code."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from operator import gt, lt, ne

from roslab.decide.decision import Reason
from roslab.decide.python.pins import Pin
from roslab.decide.python.pythons import PREFERRED
from roslab.decide.python.weights import VersionWeight as Weight
from roslab.decide.reasons import Placed, because
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.days import ended
from roslab.knowledge.frameworks import Framework, framework, last_below, meant_framework
from roslab.values.dataclass import dataclass
from roslab.values.interpreter import Interpreter
from roslab.values.open_ended import OF_LANGUAGES
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.specifier import admits, specifiers
from roslab.values.version import Version

_TRUSTED = 3
"""Of ``Pin.trust``: a manifest of the project itself."""
_CLASSIFIER = pattern(r"Python :: (\d\.\d+)")
_THREE = pattern(r"Python :: 3(?:$|\s)")
"""Python 3, whichever."""
_LEFT = pattern(r"(<|>|!=)([\d.]+)")
_SIDES: dict[str, Callable[[Version, Version], bool]] = {"<": lt, ">": gt, "!=": ne}
_ANY = Version("99")
_AFTER = 2
"""A project most likely still runs this many minor versions after its newest classifier."""


@dataclass(frozen=True, slots=True)
class Range:
    """The Pythons of ``PREFERRED`` that fit one piece of evidence, and the reason."""

    pythons: frozenset[str]
    reason: Reason
    trust: int | None = None
    """``Pin.trust`` of a pin; ``None`` for what is no pin."""


def ranges(evidence: Evidence, pins: Iterable[Pin], aside: set[str]) -> Iterator[Range]:
    """Yield declared ranges, then those of pinned packages, the most trusted first.

    ``aside`` are Dockerfiles that name their own Python: pins in one image tell nothing about the Python of another.
    """
    yield from _declared(evidence)
    for pin in pins:
        if pin.requirement.file not in aside:
            yield from _pinned(pin)
            yield from _ended(pin)


def ranges_by_syntax(evidence: Evidence) -> Iterator[Range]:
    """Yield the Pythons that can read the code."""
    for limit in evidence.limits:
        if limit.library == "Python" and limit.at_least:
            why = f"the code has {limit.what}"
            reason = because("python", f"≥ {limit.at_least}", why, limit, weight=Weight.USED)
            yield Range(_between(Version(limit.at_least), _ANY), reason)


def ranges_at_least(evidence: Evidence) -> Iterator[Range]:
    """Yield the oldest Pythons that pages name, where a day tells which newer ones there were: ``3.5 or newer``."""
    for mention in evidence.mentions:
        if mention.topic == "python" and only_oldest(evidence, mention):
            reason = because("python", f"≥ {mention.value}", f"“{mention.text[:80]}”", mention, weight=Weight.USED)
            yield Range(_between(Version(mention.value), _ANY), reason)


def ranges_left(evidence: Evidence) -> Iterator[Range]:
    """Yield the Pythons that pages leave where they say that one does not work: below ``3.8 or higher``."""
    for mention in evidence.mentions:
        sign = _LEFT.match(mention.value) if mention.topic == "no_python" else None
        if sign:
            why = f"“{mention.text[:80]}”"
            reason = because("python", f"{sign[1]} {sign[2]}", why, mention, weight=Weight.USED)
            yield Range(_beside(sign[1], Version(sign[2])), reason)


def only_oldest(evidence: Evidence, mention: Mention) -> bool:
    """Tell whether a version is only the oldest one that works, and a commit tells which newer ones there were."""
    return any(each.source == "commit" for each in evidence.worked_on) and only_lowest(mention)


def only_lowest(mention: Mention) -> bool:
    """Tell whether a version is only the oldest one that works: ``3.5+``, ``3.5 or newer``, ``≥ 3.5``."""
    number = re.escape(mention.value)
    after = rf"{number}(?:\.\d+)?(?:\s?(?:\+|\(?(?:or|and) (?:newer|later|above|higher|greater|up))|{OF_LANGUAGES})"
    return mention.source == "readme" and bool(re.search(rf"{after}|(?:>=|≥)\s?{number}", mention.text))


def recommended(mention: Mention) -> bool:
    """Tell whether a sentence recommends a version, as one of several: ``3.8 - 3.11 (recommended Python 3.8)``."""
    number = rf"{re.escape(mention.value)}(?!\d)"
    before = rf"recommend(?:ed|s)?(?: is| to use| using)?:? (?:version )?(?:python ?)?{number}"
    return bool(re.search(rf"{before}|{number} (?:is |\()recommended(?! python)", mention.text, re.IGNORECASE))


def ranges_by_use(evidence: Evidence, pins: Iterable[Pin]) -> Iterator[Range]:
    """Yield the Pythons that still have what the code uses, themselves or in the last wheels of a package.

    A package that the author pins tells nothing.
    """
    for limit in evidence.limits:
        if limit.library == "Python" and limit.below:
            why = f"the code has {limit.what}, which Python {limit.below} dropped"
            reason = because("python", f"< {limit.below}", why, limit, weight=Weight.USED)
            yield Range(_below(Version(limit.below)), reason)
    pinned = {pin.name for pin in pins if pin.trust and (pin.release or pin.requirement.below)}
    for use in evidence.bounds:
        below = use.bound.below
        row = last_below(use.bound.key, below) if below and use.bound.key not in pinned else None
        if row is not None:
            why = f"the code uses {use.what}: {use.bound.written} has wheels up to Python {row.python_max}"
            yield _up_to(row, f"≤ {row.python_max}", why, use, Weight.USED)


def _declared(evidence: Evidence) -> Iterator[Range]:
    """Yield what the manifests of the project and of its subfolders ask for."""
    for project in evidence.python:
        if project.folder.count("/") > 1 or places.vendored(project.file):
            continue
        if not (project.installable or project.refused):
            continue
        said = project.requires_python
        allowed = specifiers(said) if said else None
        if said and allowed is not None:
            why = f"{project.name or 'the project'} requires {said}"
            weight = Weight.REQUIRES_BELOW if project.folder else Weight.REQUIRES
            yield Range(_those(partial(admits, allowed)), because("python", said, why, project, weight=weight))
        elif numbers := sorted(Version(m[1]) for line in project.classifiers if (m := _CLASSIFIER.search(line))):
            first, last = numbers[0], numbers[-1]
            lowest = Version("0") if first >= Version("3") else first
            three = any(_THREE.search(line) for line in project.classifiers) or _outlived(evidence, str(last))
            three = three and last < Version("3")
            highest = _ANY if three else Version(f"{last.major}.{last.minor + _AFTER}")
            reason = because("python", f"≥ {first}", "its classifiers name them", project, weight=Weight.CLASSIFIERS)
            yield Range(_between(lowest, highest), reason)
    yield from _bounded(evidence)


def _bounded(evidence: Evidence) -> Iterator[Range]:
    """Yield what conda's environments leave of the Pythons where they name none: ``python >=3.7``."""
    for environment in evidence.conda:
        said = next((each.bounds for each in environment.packages if each.name == "python"), "")
        allowed = specifiers(said) if said else None
        if allowed is not None and environment.file.count("/") <= 1 and not places.vendored(environment.file):
            weight = Weight.REQUIRES_BELOW if "/" in environment.file else Weight.REQUIRES
            reason = because("python", said, "the conda environment allows these", environment, weight=weight)
            yield Range(_those(partial(admits, allowed)), reason)


def _outlived(evidence: Evidence, python: str) -> bool:
    """Tell whether code was worked on after a Python had ended, and is not in the syntax of Python 2 alone."""
    last = next((each for each in evidence.worked_on if each.source == "commit"), None)
    old = any(each.topic == "python" and each.source == "code" for each in evidence.mentions)
    return last is not None and not old and ended(python, last.value)


def _pinned(pin: Pin) -> Iterator[Range]:
    """Yield the Pythons that a pinned package has wheels for; lower bounds only count in the project's manifest."""
    asked = pin.requirement
    if pin.release is None and pin.trust >= _TRUSTED:
        yield from _lowest(pin)
    row = _newest_allowed(pin) if pin.trust else None
    if row is not None:
        why = f"{asked.written} has wheels for Python {row.python_min} to {row.python_max}"
        reason = because("python", f"{row.python_min}…{row.python_max}", why, asked, weight=Weight.PINS + pin.trust)
        lowest = Version(row.python_min) if pin.release else Version("0")
        fitting = _between(lowest, Version(row.python_max)) | _not_asked(asked)
        yield Range(fitting, reason, pin.trust)
    elif pin.release and pin.trust >= _TRUSTED:
        yield from _outgrown(pin, pin.release)


def _not_asked(asked: Requirement) -> frozenset[str]:
    """Return the Pythons that a requirement is not for, by its marker."""
    if asked.marker is None:
        return frozenset()
    return frozenset(python for python in PREFERRED if not Interpreter(pythons=(python,)).may(asked))


def _newest_allowed(pin: Pin) -> Framework | None:
    """Return the row of the release that a package is pinned to, or of the newest that its upper bound leaves."""
    release, below = pin.release, pin.requirement.below
    if release or below is None:
        return meant_framework(pin.name, release) if release else None
    return framework(pin.name, below) if pin.requirement.specifier.contains(below) else last_below(pin.name, below)


def _ended(pin: Pin) -> Iterator[Range]:
    """Yield the Pythons of a package that a manifest or an environment names and that is released no more."""
    from roslab.knowledge.ended_packages import ended_packages  # noqa: PLC0415 - few trees pin

    newest = ended_packages().get(pin.name) if pin.trust >= _TRUSTED - 1 else None
    if newest:
        why = f"{pin.name} ended, and has wheels up to Python {newest}"
        reason = because("python", f"≤ {newest}", why, pin.requirement, weight=Weight.PINS + pin.trust)
        yield Range(_between(Version("0"), Version(newest)), reason, pin.trust)


def _lowest(pin: Pin) -> Iterator[Range]:
    """Yield the range of a lower bound such as ``numpy>=1.22``: no Python older than that release supports."""
    asked = pin.requirement
    row = framework(pin.name, asked.at_least) if asked.at_least else None
    if row is not None:
        why = f"{asked.written} needs Python {row.python_min} or newer"
        reason = because("python", f"≥ {row.python_min}", why, asked, weight=Weight.LOWER_BOUND + pin.trust)
        yield Range(_between(Version(row.python_min), _ANY), reason, pin.trust)
    if row is None and asked.at_least:
        yield from _outgrown(pin, asked.at_least)


def _outgrown(pin: Pin, release: str) -> Iterator[Range]:
    """Yield the Pythons of a release that came after the last one for an older Python."""
    from roslab.knowledge.last_for_python import outgrown  # noqa: PLC0415 - many trees ask for no release

    if oldest := outgrown(pin.name, release):
        why = f"{pin.requirement.written} needs a Python newer than {oldest}"
        reason = because("python", f"> {oldest}", why, pin.requirement, weight=Weight.LOWER_BOUND + pin.trust)
        yield Range(_beside(">", Version(oldest)) | _not_asked(pin.requirement), reason, pin.trust)


def _up_to(row: Framework, answer: str, why: str, at: Placed, weight: int) -> Range:
    return Range(_between(Version("0"), Version(row.python_max)), because("python", answer, why, at, weight=weight))


def _between(lowest: Version, highest: Version) -> frozenset[str]:
    return _those(lambda python: lowest <= Version(python) <= highest)


def _below(version: Version) -> frozenset[str]:
    return _those(lambda python: Version(python) < version)


def _beside(sign: str, denied: Version) -> frozenset[str]:
    return _those(lambda python: _SIDES[sign](Version(python), denied))


def _those(fits: Callable[[str], bool]) -> frozenset[str]:
    return frozenset(python for python in PREFERRED if fits(python))
