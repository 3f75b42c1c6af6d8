"""Requirements that pip cannot meet with the image's Python: single lines of lists; the others need that Python.

Pins and lower bounds that no release for it meets, pins whose wheels end before it, and modules that it has itself.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.backports import backports
from roslab.knowledge.frameworks import Framework, framework, never_released, tabled
from roslab.knowledge.without_source import without_source
from roslab.values.dataclass import replace
from roslab.values.interpreter import Interpreter
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version


def unmet(asked: Requirement, python: str | None) -> bool:
    """Tell whether a requirement is for another Python than this one.

    It is pinned to a release whose first Python is newer, or begins there, or is pinned to one without a wheel and a
    source for it. Robots that raise single lines of old lists leave such pins, and lists that were written on another
    machine such bounds: pip finds no release for them and stops.
    """
    return never_was(asked) or _row(asked, python) is not None or _outgrown(asked, python) is not None


def never_was(asked: Requirement) -> bool:
    """Tell whether a requirement is pinned to a release that there never was: pip stops there, whatever the Python."""
    return bool(asked.release and not asked.url and never_released(asked.key, asked.release))


def for_newer(asked: Requirement, python: str | None) -> bool:
    """Tell whether a requirement has a release that only newer Pythons than this one run."""
    row = _row(asked, python)
    older = row is not None and Version(python or "0") < Version(row.python_min)
    return older or _outgrown(asked, python) is not None


def written_for_newer(found: Iterable[Requirement], python: str | None) -> Iterator[Warning_]:
    """Yield what is told of a list for a newer Python than ROS has: no table knows all that has no release for it."""
    for asked in [each for each in found if for_newer(each, python)][:1]:
        why = f"{asked.file} is for a newer Python than the {python} of ROS"
        yield warn(f"{why}: what of it has no release for that one is named by the build and left out", asked)


def _row(asked: Requirement, python: str | None) -> Framework | None:
    """Return the row of a release that does not run on a Python, ``None`` where it does, or nothing is known."""
    release = _lowest(asked)
    if python is None or release is None or not Interpreter(pythons=(python,)).may(asked):
        return None
    row = framework(asked.key, release)
    if row is None:
        return None
    return row if _ended(asked, row, python) or Version(python) < Version(row.python_min) else None


def _outgrown(asked: Requirement, python: str | None) -> str | None:
    """Return the newest Python that is too old for the lowest release that is asked for, if this one is no newer."""
    release = _lowest(asked)
    if python is None or release is None or not Interpreter(pythons=(python,)).may(asked):
        return None
    from roslab.knowledge.last_for_python import outgrown  # noqa: PLC0415 - where nothing has a version, nobody asks

    oldest = outgrown(asked.key, release)
    return oldest if oldest and Version(python) <= Version(oldest) else None


def _ended(asked: Requirement, row: Framework, python: str) -> bool:
    newer = without_source().get(tabled(asked.key)) if asked.release else None
    return newer is not None and row.first not in newer and Version(python) > Version(row.python_max)


def in_python(asked: Requirement, python: str | None) -> bool:
    """Tell whether a package brings a module that this Python has itself: newer ones refuse it, or break with it."""
    since = backports().get(asked.key) if python and not asked.url else None
    return since is not None and Version(python or "0") >= since and Interpreter(pythons=(python or "",)).may(asked)


def _lowest(asked: Requirement) -> str | None:
    return None if asked.url or not asked.name else asked.release or asked.at_least


def loosened(
    found: Iterable[Requirement], python: str | None, also: Container[Requirement] = ()
) -> Iterator[Requirement]:
    """Yield the requirements without what the Python has itself, and without the versions that are for another one.

    ``also``: these, too, without their versions.
    """
    for asked in found:
        if in_python(asked, python):
            continue
        if asked in also or unmet(asked, python):
            below = f"<{asked.release}" if never_was(asked) else ""
            free = stated(f"{asked.name or asked.key}{below}", asked.origin, asked.file, asked.line)
            yield replace(free, marker=asked.marker, extras=asked.extras, role=asked.role)
        else:
            yield asked


def told(asked: Requirement, python: str | None) -> Warning_:
    """Return the warning about one of them."""
    if in_python(asked, python):
        message = f"{asked.written} is left out: Python {backports()[asked.key]} and newer have it themselves"
        return warn(f"{message}, and the image has {python}", asked)
    if never_was(asked):
        return warn(f"there never was {asked.written}: pip takes the newest release of {asked.name} before it", asked)
    row = _row(asked, python)
    needs = f"needs Python {row.python_min}" if row else f"needs a Python newer than {_outgrown(asked, python)}"
    if row and Version(python or "0") > Version(row.python_max):
        message = f"{asked.written} has no wheel for a Python newer than {row.python_max}, and no source"
        instead = f'`base.python: "{row.python_max}"` in roslab.yaml takes this one, but not in an image of ROS'
        return warn(f"{message}, and the image has {python}: pip takes a release that runs there; {instead}", asked)
    message = f"{asked.written} {needs}, and the image has {python}"
    return warn(f"{message}: pip takes a release of {asked.name} that runs there", asked)
