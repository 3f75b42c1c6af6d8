"""Which version of Python the repository runs with."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.config.model import Config
from roslab.decide.decision import Reason
from roslab.decide.python.pins import Pin, pins
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.frameworks import Version, canonical, framework, last_below, version
from roslab.knowledge.tools import SYSTEM_PYTHON

PREFERRED = ("3.10", "3.8", "3.12", "3.9", "3.11", "3.7", "3.6", "3.13", "3.14", "3.5", "2.7")
"""Where several fit: what an Ubuntu ships comes first, then what most wheels exist for."""
_TABLED = {
    "tensorflow-gpu": "tensorflow",
    "tensorflow-cpu": "tensorflow",
    "jaxlib": "jax",
    "opencv-python-headless": "opencv-python",
    "opencv-contrib-python": "opencv-python",
    "opencv-contrib-python-headless": "opencv-python",
}
_SPECIFIER = re.compile(r"(>=|<=|==|~=|!=|>|<|\^)?\s*(\d+(?:\.\d+|\.\*)*)")
_AT_LEAST = re.compile(r">=\s*(\d[\w.]*)")
_TRUSTED = 3
"""Of ``Pin.trust``: a manifest of the project itself."""
_UBUNTU = re.compile(r"(?:^|/|-)ubuntu:?(\d\d\.04)")
_CLASSIFIER = re.compile(r"Python :: (\d\.\d+)")


_BOTH = re.compile(
    r"python\s*3|\b3\.\d|as well as|\bstill\b|or (?:later|newer|above)|\balso\b|\+|≥|>="
    r"|\bdrop(?:s|ped|ping)?\b|no longer|deprecat|end[- ]of[- ]life",
    re.IGNORECASE,
)


def python_version(evidence: Evidence, config: Config) -> tuple[str | None, tuple[Reason, ...]]:
    """Return ``3.8`` and why; ``None`` where the repository says nothing about Python at all."""
    if config.base.python:
        place = config.place("base.python")
        return config.base.python, (
            _reason(
                config.base.python,
                "base.python says so",
                place.file if place else None,
                place.line if place else None,
                100,
            ),
        )
    ranges = tuple(_ranges(evidence))
    named = sorted(
        _named(evidence),
        key=lambda r: (-r.weight, r.file or "", r.line or 0, [-number for number in version(r.answer)]),
    )
    fitting = [candidate for candidate in PREFERRED if _fits(candidate, ranges)]
    if not fitting:  # the pins contradict each other: believe the most trusted ones
        fitting = next(
            (
                some
                for keep in range(len(ranges) - 1, 0, -1)
                if (some := [candidate for candidate in PREFERRED if _fits(candidate, ranges[:keep])])
            ),
            list(PREFERRED),
        )
    chosen = next((reason for reason in named if reason.answer in fitting or reason.weight >= 70), None)
    if chosen is None and (older := tuple(_by_use(evidence))):  # nobody says which: what the code uses does
        ranges = (*ranges, *older)
        fitting = [candidate for candidate in fitting if _fits(candidate, older)] or fitting
    reasons = [reason for _, _, reason in ranges]
    if chosen is not None:
        return chosen.answer, (chosen, *(_aside(r, chosen.answer) for r in (*named, *reasons) if r is not chosen))
    if not ranges:
        return None, tuple(_aside(reason, "") for reason in named)
    why = _reason(fitting[0], "fits every pin below", None, None, 30)
    return fitting[0], (why, *reasons)


def _reason(answer: str, why: str, file: str | None, line: int | None, weight: int) -> Reason:
    return Reason(question="python", answer=answer, reason=why, file=file, line=line, weight=weight)


def _aside(reason: Reason, answer: str) -> Reason:
    return Reason(
        question=reason.question,
        answer=reason.answer,
        reason=reason.reason,
        file=reason.file,
        line=reason.line,
        weight=reason.weight,
        decisive=reason.answer == answer,
    )


def _named(evidence: Evidence) -> Iterator[Reason]:
    """Yield the versions that are written down as such."""
    for environment in evidence.conda:
        if environment.python and not places.vendored(environment.file):
            weight = 80 if environment.file.count("/") == 0 else 55 if environment.file.count("/") == 1 else 20
            yield _reason(environment.python, "the conda environment has it", environment.file, 1, weight)
    three = any("Python :: 3" in line for p in evidence.python if not p.folder for line in p.classifiers)
    for mention in evidence.mentions:
        if mention.topic != "python" or version(mention.value) < (2, 7):
            continue
        if mention.source == "code":
            why = "print is a statement in most of its modules"
            yield _reason(mention.value, why, mention.file, mention.line, 0 if three else 39)
            continue
        if mention.value.startswith("2") and (three or _BOTH.search(mention.text)):
            continue  # Python 3 does as well
        depth = min(mention.file.count("/"), 3)
        created = "create" in mention.text and "python" in mention.text
        weight = (
            {"readme": 40, "dockerfile": 24, "ci": 12, "script": 16}.get(mention.source, 8)
            - 4 * depth
            + (12 if created else 0)
            - (8 if _at_least(mention.value, mention.text) else 0)
        )
        yield _reason(mention.value, f"“{mention.text[:80]}”", mention.file, mention.line, weight)

    yield from _of_images(evidence)
    for pin in pins(evidence):
        if pin.trust and (tag := re.search(r"-cp(\d)(\d{1,2})-", pin.line)):
            why = "a wheel of it is named"
            yield _reason(f"{tag[1]}.{tag[2]}", why, pin.dependency.file, pin.dependency.line, 42)


def _telling(evidence: Evidence) -> set[str]:
    """Return the Dockerfiles that name the Python they are for."""
    return {m.file for m in evidence.mentions if m.topic == "python" and m.source == "dockerfile"}


def _of_images(evidence: Evidence) -> Iterator[Reason]:
    """Yield the Python of the Ubuntu that a Dockerfile starts from, where it installs packages and names none."""
    telling = _telling(evidence)
    for authored in evidence.dockerfiles:
        tag = (
            _UBUNTU.search(authored.base or "")
            if authored.purpose == "project" and authored.file not in telling
            else None
        )
        number = SYSTEM_PYTHON.get(ubuntus().get(tag[1], "")) if tag else None
        if number and any(d.namespace == "pip" for d in authored.dependencies):
            weight = 16 - 4 * min(authored.file.count("/"), 3)
            yield _reason(number, f"the Python of {authored.base}", authored.file, authored.base_line, weight)


def _ranges(evidence: Evidence) -> Iterator[tuple[Version, Version, Reason]]:
    """Yield ``(lowest, highest, reason)``: declared ranges, then those of pinned packages, the most trusted first."""
    for project in evidence.python:
        if project.folder.count("/") > 1 or places.vendored(project.file) or not project.installable:
            continue
        if project.requires_python and (bounds := _bounds(project.requires_python)):
            why = f"{project.name or 'the project'} requires {project.requires_python}"
            yield (
                *bounds,
                _reason(project.requires_python, why, project.file, project.line, 45 - 10 * bool(project.folder)),
            )
        elif numbers := sorted(version(m[1]) for line in project.classifiers if (m := _CLASSIFIER.search(line))):
            why = "its classifiers name them"
            yield (
                (0,) if numbers[0] >= (3,) else numbers[0],
                (numbers[-1][0], numbers[-1][1] + 2),
                _reason(f"≥ {_text(numbers[0])}", why, project.file, project.line, 10),
            )
    telling = _telling(evidence)
    for pin in pins(evidence):
        if pin.dependency.file in telling:
            continue  # of several images the pins of one say nothing of another's Python
        release = pin.release or pin.below
        if pin.release is None and pin.trust >= _TRUSTED:
            yield from _lowest(pin)
        if release is None or not pin.trust:
            continue
        row = framework(_TABLED.get(pin.name, pin.name), release)
        if row is not None:
            lowest = version(row.python_min) if pin.release else (0,)
            why = f"{pin.line} has wheels for Python {row.python_min} to {row.python_max}"
            place = (pin.dependency.file, pin.dependency.line)
            yield (
                lowest,
                version(row.python_max),
                _reason(f"{row.python_min}…{row.python_max}", why, *place, 30 + pin.trust),
            )


def _by_use(evidence: Evidence) -> Iterator[tuple[Version, Version, Reason]]:
    """Yield the Pythons of the last wheels with a name that the code uses, where the author pins nothing himself."""
    pinned = {pin.name for pin in pins(evidence) if pin.trust and (pin.release or pin.below)}
    for use in evidence.bounds:
        package, _, below = use.name.partition("<")
        row = None if canonical(package) in pinned else last_below(canonical(package), below)
        if row is not None:
            why = f"the code uses {use.role}: {use.name} has wheels up to Python {row.python_max}"
            yield (0,), version(row.python_max), _reason(f"≤ {row.python_max}", why, use.file, use.line, 20)


def _at_least(number: str, text: str) -> bool:
    """Tell whether ``3.5`` is only the oldest that does: ``3.5+``, ``3.5 or newer``."""
    return bool(re.search(rf"{re.escape(number)}\s?(?:\+|or (?:newer|later|above|higher))", text))


def _lowest(pin: Pin) -> Iterator[tuple[Version, Version, Reason]]:
    """Yield the range of ``numpy>=1.22``: no Python that is older than the first with that release."""
    at_least = _AT_LEAST.search(pin.line.partition(";")[0])
    row = framework(_TABLED.get(pin.name, pin.name), at_least[1]) if at_least else None
    if row is not None:
        why = f"{pin.line} needs Python {row.python_min} or newer"
        place = (pin.dependency.file, pin.dependency.line)
        yield version(row.python_min), (99,), _reason(f"≥ {row.python_min}", why, *place, 29 + pin.trust)


def _text(numbers: Version) -> str:
    return ".".join(map(str, numbers))


def _bounds(specifier: str) -> tuple[Version, Version] | None:
    lowest: Version = (0,)
    highest: Version = (99,)
    for operator, text in _SPECIFIER.findall(specifier):
        numbers = version(text.replace(".*", ""))[:2]
        if not numbers:
            continue
        if operator in {">=", ">"}:
            lowest = max(lowest, numbers)
        elif operator in {"", "=="}:
            lowest, highest = numbers, numbers
        elif operator in {"~=", "^"}:
            lowest, highest = max(lowest, numbers), (numbers[0], 99)
        elif operator == "<=":
            highest = min(highest, numbers)
        elif operator == "<":
            highest = min(
                highest, (numbers[0] - 1, 99) if len(numbers) == 1 or not numbers[1] else (numbers[0], numbers[1] - 1)
            )
    return lowest, highest


def _fits(candidate: str, ranges: tuple[tuple[Version, Version, Reason], ...]) -> bool:
    number = version(candidate)
    return all(lowest <= number and number[: len(highest)] <= highest for lowest, highest, _ in ranges)
