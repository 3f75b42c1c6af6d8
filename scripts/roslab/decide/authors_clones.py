"""What the author's Dockerfile, where that is built, clones: its steps alone say what comes from source."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import BuildTool, Config, Source
from roslab.decide.authors_heads import at_head
from roslab.decide.chains import decide_bases, local_bases
from roslab.decide.decision import Choice, Warning_
from roslab.decide.reasons import because, warn
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.edited import with_edits
from roslab.decide.ros.forks import with_forks
from roslab.decide.ros.marked_clones import with_marks
from roslab.decide.ros.patched import with_patches
from roslab.decide.ros.source_names import address, fixed
from roslab.decide.system.names import Target
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.python_steps import image_at
from roslab.knowledge.days import long_ago
from roslab.values.dataclass import replace

WEIGHT = 60
MOST = 8
"""Most clones that are told."""


def authors_clones(
    sources: Choice[Sources],
    evidence: Evidence,
    dockerfile: str | None,
    config: Config,
    *,
    target: Target,
    build_tool: BuildTool,
) -> Choice[Sources]:
    """Return the sources as the author changes them, or those that a ``dockerfile`` clones, as it says.

    Old code is told of each clone at a head of which the build takes the newest commit, for nothing gives it that of
    the day. An old format builds as it did, without patches.
    """
    if dockerfile is None:
        sources = with_forks(sources, evidence, config, ros_distro=target.ros_distro, build_tool=build_tool)
        if not config.compatible:
            sources = with_edits(with_patches(sources, evidence), evidence)
        return with_marks(sources, evidence)
    told: dict[str, GitSource] = {}
    for git in _clones(evidence, dockerfile):
        if "$" not in git.url and not git.removed:
            told.setdefault(address(git.url), git)
    days = _days(evidence, config, dockerfile, told.values())
    found = tuple(
        Source(name=git.name, repo=git.url, ref=fixed(git.ref), before=days.get(git, "")) for git in told.values()
    )
    reasons = tuple(
        because("source", g.url, "the author's Dockerfile clones it", g, weight=WEIGHT) for g in told.values()
    )
    warnings = tuple(_at_heads(evidence, (git for git in told.values() if git not in days)))[:MOST]
    return Choice(answer=replace(sources.answer, sources=found, libraries=()), reasons=reasons, warnings=warnings)


def _clones(evidence: Evidence, dockerfile: str) -> Iterator[GitSource]:
    """Yield what it clones, first what the Dockerfile of its base does, if that is of the tree."""
    base = local_bases(evidence).get(dockerfile)
    files = (*((base.dockerfile.file,) if base and base.dockerfile else ()), dockerfile)
    for file in files:
        yield from (git for each in evidence.dockerfiles if each.file == file for git in each.clones)


def _days(evidence: Evidence, config: Config, dockerfile: str, clones: Iterable[GitSource]) -> dict[GitSource, str]:
    """Return the day of each clone of a Dockerfile at a head that the build takes as it was on that day."""
    days = {base.name: base.git_day for base in decide_bases(evidence, config, dockerfile).answer}
    if not days:
        return {}
    stages = next(each.stages for each in evidence.dockerfiles if each.file == dockerfile)
    found = {git: days.get(image_at(git.line, stages)) for git in clones if git.file == dockerfile and at_head(git)}
    return {git: day for git, day in found.items() if day}


def _at_heads(evidence: Evidence, clones: Iterable[GitSource]) -> Iterator[Warning_]:
    last = dated(evidence)
    if last is None or last.value >= long_ago():
        return
    for git in clones:
        if at_head(git):
            at = f"at its branch {git.ref}" if git.ref else "without a tag or a commit"
            message = (
                f"{git.url} is cloned {at}: the author's Dockerfile takes its newest commit of the day of the build"
            )
            yield warn(
                f"{message}, not one of {last.value}, the day of the last commit here; name one in this line", git
            )
