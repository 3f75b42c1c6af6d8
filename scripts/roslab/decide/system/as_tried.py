"""What the build looks for elsewhere once it is known which packages are built."""

from __future__ import annotations

from collections.abc import Collection

from roslab.decide.decision import Choice
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.keys import not_tried
from roslab.decide.ros.sought import tried, without
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.packages import SystemPackages
from roslab.values.dataclass import replace


def as_tried(
    sources: Choice[Sources],
    system: Choice[SystemPackages],
    packages: Packages,
    left_out: Collection[str],
    stops: Collection[str],
    *,
    none: bool,
) -> tuple[Choice[Sources], Choice[SystemPackages]]:
    """Return both with no more than the repositories in which the build looks; ``none``: the author's own does not.

    ``stops``: what the build stops without.
    """
    kept = without(sources, packages, left_out, none=none)
    before, after = tried(sources.answer.sought), tried(kept.answer.sought)
    return kept, replace(system, warnings=tuple(not_tried(system.warnings, before, after, stops)))
