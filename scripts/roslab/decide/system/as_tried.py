"""What is left out, and what is cloned or built for the rest, once it is known which packages are built."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.author_dockerfile import Dockerfile
from roslab.decide.command import Command
from roslab.decide.decision import Choice
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.keys import not_tried
from roslab.decide.ros.sought import tried, without
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.for_spare_packages import for_spare_packages
from roslab.decide.system.missing import Missing
from roslab.decide.system.packages import SystemPackages
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def as_tried(
    sources: Choice[Sources],
    system: Choice[SystemPackages],
    missing: Missing,
    evidence: Evidence,
    config: Config,
    *,
    packages: Packages,
    command: Command,
    own: Dockerfile | None,
) -> tuple[tuple[str, ...], Choice[Sources], Choice[SystemPackages]]:
    """Return the packages that are left out, and both with no more than what the build looks in for the others.

    ``own``: the author's Dockerfile that is built, which leaves out none and looks nowhere.
    """
    left_out = () if own else missing.packages
    kept = without(sources, packages, left_out, none=own is not None)
    before, after = tried(sources.answer.sought), tried(kept.answer.sought)
    kept = kept if own else for_spare_packages(kept, evidence, config, packages, command, left_out=left_out)
    return left_out, kept, replace(system, warnings=tuple(not_tried(system.warnings, before, after, missing.stops)))
