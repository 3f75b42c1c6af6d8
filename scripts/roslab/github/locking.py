"""What a run does with the lock of a repository before it builds, and with that of its image after its proof."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.engine.secrets import Secret
from roslab.errors import BuildError, Problem
from roslab.github import kept as attempts
from roslab.github import workflow
from roslab.github.run import Folder, Run, artifact_name, slug
from roslab.lock import check, inventory, making
from roslab.lock.materials import of_metadata
from roslab.plan.lock import digest, from_text, to_text, without
from roslab.plan.locked import NAME, Lock
from roslab.plan.plan import Plan
from roslab.render.dockerfile import question
from roslab.values.dataclass import replace

ANNOTATION = "roslab.lock"
"""Of a published index: the digest of its lock."""
TYPE = "https://github.com/org/repro-action/roslab.lock/v1"
"""Of the statement about an image that holds its lock: https://github.com/in-toto/attestation/blob/main/spec/v1/predicate.md"""
PART = "lock-{}.json"
"""File of one platform among what a job keeps."""
SECONDS = 60.0
"""Longest that the package sources are asked."""


def available(plan: Plan, platforms: Sequence[str], secrets: Sequence[Secret] = ()) -> Plan:
    """Return the plan without what its lock names and nobody has any more; each is told before the build."""
    if plan.lock is None or plan.author_dockerfile:
        return plan
    for platform in platforms:
        with workflow.group(f"Ask for what {NAME} names, for {platform}"):
            answer = check.check(plan, question(plan), platform, secrets)
        for said in answer.silent:
            workflow.say(said)
        for each in answer.missing:
            workflow.warn(Problem(message=f"{NAME}: {each}"))
        plan = without(plan, answer.missing)
    return plan


def keep(folder: Folder, run: Run, reference: str, platform: str, metadata: str) -> None:
    """Keep the lock of a proved image that the engine holds; a lock that cannot be made fails nothing and is told.

    ``metadata`` is what buildx says of the build, with the images that an author's own Dockerfile started from.
    """
    try:
        known = run.plan.lock.materials if run.plan.lock else ()
        taken = of_metadata(metadata, known) if run.plan.author_dockerfile else ()
        image = inventory.read(reference, platform)
        lock = making.make(run.plan, [(platform, image)], taken, seconds=SECONDS)
    except BuildError as error:
        workflow.warn(Problem(message=f"{platform} gets no lock: {error.problems[0].message}"))
        return
    (folder.artifact / PART.format(slug(platform))).write_text(to_text(lock), encoding="utf-8")


def gathered(folder: Path, run: Run) -> str:
    """Return the text of the lock of all platforms, ``""`` where one of them has none.

    ``folder`` holds what the jobs kept; of a job that ran again its newest attempt counts.
    Raises ``ConfigurationError`` for a file that is no lock.
    """
    newest = attempts.gather(folder)
    parts: list[Lock] = []
    for platform in run.plan.platforms:
        found = [file for job in newest if job.folder and (file := job.folder / PART.format(slug(platform))).is_file()]
        if not found:
            return ""
        parts.append(from_text(found[-1].read_text(encoding="utf-8"), file=found[-1].name))
    sources = {(each.name, each.url): each for part in parts for each in part.sources}
    taken = {each.source: each for part in parts for each in part.materials}
    merged = replace(
        parts[0],
        sources=tuple(sources[key] for key in sorted(sources)),
        machines=tuple(machine for part in parts for machine in part.machines),
        materials=tuple(taken[key] for key in sorted(taken)),
    )
    return to_text(merged)


def kept(folder: Folder, reports: Path, environment: Mapping[str, str]) -> dict[str, str]:
    """Output where the lock of the run's image lies, and return the annotation that names it, none without a lock.

    The outputs are ``lock``, a path or ``""``, ``lock-artifact`` and ``lock-type``.
    """
    run = folder.run
    text = gathered(reports, run) if run.lock else ""
    if not text:
        return {}
    folder.write(NAME, text)
    name = f"{artifact_name('lock', run)}-{environment.get('GITHUB_RUN_ATTEMPT') or 1}"
    folder.write("lock-artifact", name)
    workflow.outputs({"lock": str(folder.path / NAME), "lock-artifact": name, "lock-type": TYPE}, environment)
    return {ANNOTATION: digest(text)}
