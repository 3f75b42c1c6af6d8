"""Which packages of the repository may fail to compile, which may not, and what the warnings say of both."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import TYPE_CHECKING

from roslab.config.model import Config
from roslab.decide.decision import Choice, Warning_
from roslab.decide.programs import owner
from roslab.decide.ros.keys import once, stopping
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.may_fail import may_fail
from roslab.decide.system.missing import Missing
from roslab.decide.system.must_build import must_build
from roslab.decide.system.of_vendors import what_stops
from roslab.decide.system.packages import SystemPackages
from roslab.decide.system.spare import spare
from roslab.decide.system.strays import spare_projects
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from roslab.decide.assembled import Choices

_STOPS = pattern(r"\b[a-z_]+ will (?:most likely )?stop (?:there|at \w+)(?=; )")
"""What a warning says of a package that lacks something, whoever needs that package."""


@dataclass(frozen=True, kw_only=True, slots=True)
class GoesWithout:
    """The packages that the build may go without, those that it may not, and the choices that tell of them."""

    whole: bool
    """Nothing is left out: an author's Dockerfile, an old form of roslab.yaml, or no packages of ROS."""
    failing: tuple[str, ...]
    needed: tuple[str, ...]
    alone: tuple[str, ...]
    """The folders of those that nothing needs, where a shell is started, or what no page says."""
    plain: tuple[str, ...]
    """The folders of projects without a package.xml that the tool builds too, and that nothing needs."""
    system: Choice[SystemPackages]
    missing: Choice[Missing]


def goes_without(of: Choices, evidence: Evidence, config: Config) -> GoesWithout:
    """Return these, with warnings that say what becomes of each package; of the author's Dockerfile as they are."""
    failing = may_fail(
        evidence, of.packages, of.target, of.sources.answer, of.left_out, stopping=of.missing.answer.stopping
    )
    needed = must_build(
        evidence,
        of.command.answer.command,
        of.packages,
        of.sources.answer,
        left_out={*of.left_out, *failing},
        ros_distro=of.release.answer.name if of.release.answer else None,
    )
    whole = bool(of.own.answer or config.compatible or of.kind.answer not in {"ros1", "ros2"})
    alone = (
        ()
        if whole
        else spare(evidence, config, of.command.answer, of.packages, left_out={*of.left_out, *failing}, started=needed)
    )
    told = stopping(once(of.system.warnings, of.missing.warnings), of.packages, needed, evidence)
    told = what_stops(told, of.packages, {*alone, *failing, *of.left_out}, of.build_tool.answer)
    may_go, gone = ({*failing} - {*needed}, of.left_out) if not whole else ((), ())
    missing = replace(of.missing, warnings=tuple(_left_out(of.missing.warnings, of.packages, may_go, gone)))
    return GoesWithout(
        whole=whole,
        failing=failing,
        needed=needed,
        alone=alone,
        plain=()
        if whole
        else spare_projects(
            evidence, of.packages, of.build_tool.answer, of.command.answer.command, of.missing.answer.strays
        ),
        system=of.system if of.own.answer else replace(of.system, warnings=tuple(told)),
        missing=missing,
    )


def _left_out(
    warnings: Iterable[Warning_], packages: Packages, may_go: Collection[str], gone: Collection[str]
) -> Iterator[Warning_]:
    """Yield the warnings; where the build goes on without a package that does not compile, or has none, with that."""
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    for warning in warnings:
        package = owner(warning.file or "", folders)
        if package is None or package not in {*may_go, *gone}:
            yield warning
            continue
        then = f"{package} is left out of the build"
        then = then if package in gone else f"where it does not compile, {then}"
        yield replace(warning, message=_STOPS.sub(then, warning.message))
