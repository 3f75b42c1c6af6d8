"""Lists that are for Python 2 by their names, in an image whose own Python is 3: their versions give way."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.python.beside_nodes import Loose
from roslab.decide.reasons import warn
from roslab.evidence.facts import RequirementFile
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_NAMED = pattern(
    r"(?<![a-z0-9])py(?:thon)?[-_.]?2(?:[-_.]?[67])?(?![a-z0-9])|(?:requirements?|reqs?|pip)[-_.]?2[-_.]?7(?!\d)",
    re.IGNORECASE,
)
"""``requirements_py27``, ``python2``, ``lab_requirements2.7``; ``py2neo``, ``numpy2``, ``torch2.7`` are others."""


def for_python2(files: Iterable[RequirementFile], python: str | None) -> Loose:
    """Return the lines with a version of such lists, for a version of Python, each with what is told of its list.

    What a release of that time compiles does not compile with a Python 3 of a later one, and nobody tried it there.
    """
    return dict(_lines(files, python)) if python and python.startswith("3") else {}


def _lines(files: Iterable[RequirementFile], python: str) -> Iterator[tuple[Requirement, Warning_]]:
    for file in files:
        if _NAMED.search(posixpath.splitext(posixpath.basename(file.file))[0]):
            why = f"{file.file} is for Python 2 by its name, and the image has {python}"
            told = warn(f"{why}: its packages are installed in releases that run there", file)
            yield from ((each, told) for each in file.requirements if each.specifier and each.name and not each.url)
