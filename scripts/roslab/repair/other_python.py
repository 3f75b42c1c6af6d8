"""A pinned release that pip cannot build here, and of which its index has a wheel for another Python."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from roslab.decide.python.pythons import PREFERRED
from roslab.decide.python.requires import refusing
from roslab.errors import BuildError
from roslab.explain.answer import Answer, Explanation
from roslab.repair.by_hand import yielding
from roslab.repair.change import Asked, Change, Given, Repair
from roslab.repair.releases import pinned
from roslab.repair.said import by_machine
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.version import Version, minor_of, version_of

KEY = "base.python"
OLDEST = "3.6"
"""The first Python that is asked for: wheels of older ones serve nobody."""
_FAILED = pattern(
    r"(?m)^\s{0,8}(?:ERROR: )?Failed (?:building wheel for|to build) '?(?P<name>[A-Za-z0-9][\w.-]{0,99}?)'?(?=\s|$)"
    r"|generating package metadata\.\n[^\n]{0,4}\u2570\u2500> (?P<second>[A-Za-z0-9][\w.-]{0,99})\s{0,4}$"
)
_INDEX = pattern(r"(?:-i|--index-url)[= ]")
_NOT = ("installable", "unknown", "UNKNOWN")
"""Words that pip writes in the place of a name."""
_LINE = pattern(r"(?m)^(?P<name>[A-Za-z0-9][\w.-]{0,99}) (?P<python>\d\.\d{1,2})$")


@dataclass(frozen=True, kw_only=True, slots=True)
class Sought:
    """One release that did not build."""

    found: Explanation
    asked: Requirement
    release: Version
    """As its source is called, and the index lists it: ``2.0.0`` for a pin of ``2``."""
    pythons: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.asked.key} {self.release} {' '.join(self.pythons)}"


def sought(answer: Answer, given: Given) -> tuple[Sought, ...]:
    """Return the pinned releases that did not build in a step of pip, where the image may have another Python.

    The image's own Python is asked for, too: what has a wheel for it fails for another reason. One that a repair took
    is not exchanged again.
    """
    plan = given.plan
    fixed = plan.ros_distro or plan.author_dockerfile or plan.python.conda_file or plan.python.conda_specs
    now = minor_of(plan.python.version or "")
    if fixed or KEY in given.added or given.config.base.image or now is None or _elsewhere(given):
        return ()
    pythons = [each for each in PREFERRED if Version(each) >= Version(OLDEST)]
    pythons = [each for each in pythons if refusing(each, given.evidence.python) is None]
    pythons = [now, *(each for each in pythons if each != now)]
    return tuple(
        Sought(found=found, asked=asked, release=release, pythons=tuple(pythons))
        for found in answer.explanations
        if "pip" in found.step and not by_machine(found)
        for asked, release in _unbuilt(found, given)
    )


def _elsewhere(given: Given) -> bool:
    """Tell whether a list names another index in place of pip's own, which is not asked for what that holds."""
    files = (each for each in given.evidence.requirements if each.file in given.plan.python.requirements)
    return any(_INDEX.match(option) for file in files for option in file.options)


def _unbuilt(found: Explanation, given: Given) -> Iterator[tuple[Requirement, Version]]:
    """Yield the pins of what pip fetched as a source and did not build, each with its release."""
    names = dict.fromkeys(match["name"] or match["second"] for match in _FAILED.finditer(found.log))
    for name in [name for name in names if name not in _NOT][:3]:
        like = re.sub(r"[-_.]+", "[-_.]", name)
        source = re.search(rf"(?i)(?<![\w.-]){like}-(\d[\w.!+]{{0,60}}?)(?:\.tar\.\w{{2,3}}|\.zip)", found.log)
        release = version_of(source[1]) if source else None
        asked = pinned(given, name, release) if release is not None else None
        if asked is not None and release is not None:
            yield asked, release


def completed(found: Repair, answer: Answer, given: Given, ask: Callable[[Sequence[str]], str]) -> Repair:
    """Return a repair with the newest Python for which pip's index has a wheel, where nothing else is certain.

    ``ask`` gives the answer of the index for lines of a name, a release and Pythons, and raises ``BuildError``.
    """
    wanted = sought(answer, given) if not found.certain.changes else ()
    if not wanted:
        return found
    try:
        said = {(match["name"], match["python"]) for match in _LINE.finditer(ask([str(each) for each in wanted]))}
    except BuildError as error:
        return _refused(found, wanted[0], f"pip's index was not asked for wheels: {error.problems[0].message}")
    fitting = [
        {python for name, python in said if name == each.asked.key and python in each.pythons} for each in wanted
    ]
    for each, pythons in zip(wanted, fitting, strict=True):
        if each.pythons[0] in pythons:
            return found
        if not pythons:
            return _refused(found, each, f"pip's index has no wheel of {each.asked.written} for any Python that fits")
    common = set.intersection(*fitting)
    if not common:
        return _refused(found, wanted[0], "no Python has wheels for all that does not build")
    first = wanted[0].asked
    place = Place(file=first.file, line=first.line) if first.file else None
    change = Change(
        key=KEY,
        value=max(common, key=Version),
        failure=wanted[0].found.id or "",
        certain=True,
        asked=Asked(what=f"the wheel of {first.written}", place=place),
    )
    return replace(found, changes=(*found.changes, yielding(change, given)))


def _refused(found: Repair, each: Sought, why: str) -> Repair:
    failure = each.found.id or ""
    return replace(found, refused=((failure, why), *(one for one in found.refused if one[0] != failure)))
