"""The Pythons for which a package source has modules: those of the Ubuntus that it builds for."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.python.ranges import Range
from roslab.decide.python.weights import VersionWeight as Weight
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.knowledge.apt_sources import added_sources
from roslab.knowledge.distros import python_of_ubuntu
from roslab.values.pattern import pattern

_OF_PYTHON = pattern(r"-py3(?:\d{1,2}|\*)-")
"""In the name of such a package: the Python of an Ubuntu, which may be another than the image's."""


def ranges_of_sources(evidence: Evidence) -> Iterator[Range]:
    """Yield the Pythons of a source whose modules a page installs by apt: they are for no other one."""
    asked = [each for each in evidence.prose if each.namespace == "apt" and _OF_PYTHON.search(each.name)]
    for source in added_sources() if asked else ():
        named = next((each for each in asked if source.folder and source.packages.fullmatch(each.name)), None)
        if named:
            pythons = frozenset(python_of_ubuntu()[ubuntu] for ubuntu in source.ubuntu)
            why = f"{named.name} is of a source that has modules for the Python of an Ubuntu alone"
            yield Range(pythons, because("python", "of an Ubuntu", why, named, weight=Weight.USED))
