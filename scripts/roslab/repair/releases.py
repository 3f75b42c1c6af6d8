"""Another release than a pinned one: the nearest that the index has, or a newer one that runs on ROS's Python."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from roslab.decide.python.bounds import excluded
from roslab.explain.answer import Explanation
from roslab.knowledge.distros import python_of_ubuntu
from roslab.knowledge.removals import removals
from roslab.repair.asked import FRAME
from roslab.repair.change import Given, Worked
from roslab.values.name import canonicalize_name
from roslab.values.origin import Place
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import requirement, stated
from roslab.values.version import Version, version_of

_PIN = pattern(r"==\s*(?P<release>\d[\w.!+]{0,60})$")
_CUT = "…"
"""What stands in place of the middle of a long line."""
_INSTALLED = pattern(r"/(?:site|dist)-packages/")
_LISTED = pattern(r"\(from versions: (?P<versions>[^)\n]{1,20000})\)")


def nearest(found: Explanation, given: Given) -> tuple[str, str, str]:
    """Return the line of pip to write, what it stands in place of in roslab.yaml, and why there is none.

    The next release after the pinned one with the same first number, else the last one before it: what pip's own
    message lists runs on this Python. Of a pin with a label (``1.7.1+cu110``), the same release without it comes first.
    Nothing where all listed ones are newer, for then this Python is most likely too new for the pinned one; nor where
    another package pins it, which roslab.yaml cannot change.
    """
    names: Mapping[str, str] = dict(found.names)
    name, pin = names.get("name", ""), _PIN.search(names.get("version", ""))
    wanted = version_of(pin["release"]) if pin else None
    if pin is None or wanted is None:
        return "", "", found.fix
    asked = pinned(given, name, wanted)
    if asked is None:
        return "", "", f"another package asks for {name}=={pin['release']}: pin one that does not"
    listed = _listed(found.log, name, pin["release"], wanted)
    if not listed or listed[0] > wanted:
        return "", "", found.fix
    same = [each for each in listed if each.release[0] == wanted.release[0]]
    later = [each for each in same if each > wanted]
    if not same:
        return "", "", f"the index has no release of {name} that begins with {wanted.release[0]}: {found.fix}"
    extras = f"[{','.join(asked.extras)}]" if asked.extras else ""
    own = asked.written if asked.origin == "configuration" else ""
    unlabelled = [each for each in same if wanted.local and each.public == wanted.public]
    return f"{asked.name}{extras}=={(unlabelled or later or same[-1:])[0]}", own, ""


def newer(found: Explanation, given: Given) -> tuple[str, str]:
    """Return the line of pip for a newer release than the one that is pinned, and what it stands in place of.

    Nothing where the repository does not pin the package whose code does not fit the Python: it pins what is to blame
    for that, or another package brings it.
    """
    key = canonicalize_name(dict(found.names).get("package", ""))
    asked = next((each for each in _asked(given) if key and each.key == key and each.release), None)
    if asked is None:
        return "", ""
    extras = f"[{','.join(asked.extras)}]" if asked.extras else ""
    return f"{asked.name}{extras}>{asked.release}", asked.written if asked.origin == "configuration" else ""


def pinned(given: Given, name: str, wanted: Version) -> Requirement | None:
    """Return the line of roslab.yaml, of a list or a project that pins a package to this release."""
    key = canonicalize_name(name)
    found = (each for each in _asked(given) if each.key == key and each.release)
    return next((each for each in found if version_of(each.release or "") == wanted), None)


def _asked(given: Given) -> Iterator[Requirement]:
    """Yield what roslab.yaml, the lists and the projects of the repository ask for."""
    yield from (each for line in given.config.pip if (each := requirement(line, "configuration")) is not None)
    for file in given.evidence.requirements:
        yield from file.requirements
    for project in given.evidence.python:
        yield from project.requirements


def _listed(log: str, name: str, release: str, wanted: Version) -> list[Version]:
    """Return the releases that pip lists, in order; none where it listed more than was kept, and the pin is there."""
    said = rf"requirement {re.escape(name)}(?:\[[^\]\n]{{1,80}}\])?=={re.escape(release)}[ ;(]"
    line = next((line for line in log.splitlines() if "from versions: " in line and re.search(said, line)), "")
    match = _LISTED.search(line)
    first, cut, second = match["versions"].partition(_CUT) if match else ("", "", "")
    below, above = first.split(","), second.split(",")
    parts = (below[:-1], above[1:]) if cut else (below, above)  # what lies beside the cut is half a number
    low, high = (sorted(filter(None, map(version_of, map(str.strip, part)))) for part in parts)
    if cut and (not low or not high or low[-1] < wanted < high[0]):
        return []
    return [each for each in (*low, *high) if not each.is_prerelease or wanted.is_prerelease]


def dropped(found: Explanation, given: Given) -> Worked:
    """Take a release that still has what was dropped, if this Python has one.

    What the repository asks for stays, but a line of a list gives way to roslab.yaml's where it is an installed package
    that misses what was dropped: then the list contradicts itself.
    """
    names = dict(found.names)
    limit, newest = names.get("limit", ""), names.get("newest_python", "")
    python = given.plan.python.version or python_of_ubuntu().get(given.plan.ubuntu or "", "")
    if newest and python and Version(python) > Version(newest):
        other = "the code needs a newer version" if given.plan.ros_distro else f"`base.python: '{newest}'` has one"
        return Worked(why=f"{limit} has no wheel for Python {python}: {other}")
    asked, bound = tuple(_installed(given)), stated(limit)
    frames = [match["file"] for match in FRAME.finditer(found.log)]
    contradicted = bool(frames) and _INSTALLED.search(frames[-1]) is not None
    lists = {each.file for each in given.evidence.requirements}
    for line in asked:
        if excluded(bound, (line,)) and not (contradicted and line.file in lists):
            place = Place(file=line.file, line=line.line)
            return Worked(why=f"{place} asks for {line.written}: take a release of {limit} there")
    with_it = next((each.beside for each in removals() if each.having == limit), None)
    needed = with_it is not None and with_it.written not in given.plan.python.bounds and not excluded(with_it, asked)
    return Worked(values=(limit, with_it.written) if with_it and needed else (limit,))


def _installed(given: Given) -> Iterator[Requirement]:
    """Yield what roslab.yaml, and the lists and projects that the image installs, ask for in any case."""
    for index, text in enumerate(given.config.pip):
        at = given.config.origin(f"pip.{index}") or given.config.origin("pip")
        place = at if isinstance(at, Place) else Place(file=given.config.file or "roslab.yaml")
        if asked := requirement(text, "configuration", place.file, place.line or 1):
            yield asked
    plan = given.plan.python
    apart = {*plan.pip, *plan.pip_guessed}  # lines of lists that are not installed as they are
    for line in (line for each in given.evidence.requirements for line in each.requirements):
        if line.file in plan.requirements or line.text in apart:
            yield line
    for project in given.evidence.python:
        if (project.file.rpartition("/")[0] or ".") in plan.projects:
            yield from (each for each in project.requirements if not each.role)
