"""Packages that no package.xml names and that CMake or launch files need: the build looks for them all the same."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.workspace import Packages
from roslab.knowledge.released import rosdep_keys


def wanted_beside(sources: Sources, packages: Packages, required: Iterable[str]) -> tuple[str, ...]:
    """Return what CMake requires (``required``), what the default launch file needs, and what is only tried.

    In alphabetical order. The build looks for these in the lists of what it clones, and for what they need in turn. Not
    for what a package.xml of the tree names: rosdep tells of that.
    """
    keyed = {asked.name for manifest in packages.built for asked in manifest.dependencies}
    tried = (name for source in sources.sought for name in source.holding)
    return tuple(sorted({*required, *sources.started, *tried} - keyed - rosdep_keys() - sources.modules))
