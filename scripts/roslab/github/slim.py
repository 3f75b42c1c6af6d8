"""The slim image of a run: made out of the whole one once that has passed, and proved like it.

What fails here is told, and withholds the tags of the slim image alone.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.engine import docker as engine
from roslab.engine import registry
from roslab.errors import BuildError, Problem
from roslab.github import disk, proving, tags, workflow
from roslab.github import run as runs
from roslab.github.run import Folder, Run
from roslab.plan.plan import SLIM
from roslab.render.outcome import PlatformReport, SlimReport
from roslab.values.dataclass import replace


def complete(run: Run, reports: Sequence[PlatformReport]) -> bool:
    """Tell whether the slim image holds on every platform; with one missing it gets no tag."""
    held = {each.platform for each in reports if each.slim and each.slim.source and not each.slim.failure}
    return run.plan.slim and held == set(run.plan.platforms)


def slim(environment: Mapping[str, str]) -> None:
    """Build the slim image for every platform of this job, and prove it."""
    folder = Folder.of(environment)
    run = folder.run
    build = json.loads(folder.read("build.json"))
    platforms = tuple(build["platforms"].split(","))
    screenshots = folder.path / SLIM  # those of the whole image are the ones that are kept
    screenshots.mkdir(exist_ok=True)
    try:
        make = _pushed if run.push else _loaded
        found = make(folder, run, build, platforms, screenshots, environment)
    except BuildError as error:
        found = {platform: SlimReport(failure=error.problems[0].message) for platform in platforms}
    for platform in platforms:
        report = found.get(platform) or SlimReport(failure=f"the registry holds none for {platform}")
        folder.write_report(replace(folder.report(platform), slim=report))
        if report.failure:
            hint = "the whole image is not touched by this; README.md says what a slim image leaves out"
            workflow.warn(Problem(message=f"the slim image gets no tag: {report.failure}", hint=hint))


def _pushed(  # noqa: PLR0917 - what one platform's build is made of
    folder: Folder,
    run: Run,
    build: Mapping[str, str],
    platforms: tuple[str, ...],
    screenshots: Path,
    environment: Mapping[str, str],
) -> dict[str, SlimReport]:
    """Push the images by digest, without a tag, and prove what the registry holds."""
    job, variables = proving.again(folder, run, build, environment)
    said = (f"--provenance={build['provenance']}", *([f"--sbom={build['sbom']}"] if build["sbom"] else []))
    noted = tuple(f"--annotation={line}" for line in build["annotations"].splitlines())
    job = replace(job, platforms=platforms, target=SLIM, output=build["exporter"], extra=(*said, *noted))
    with workflow.group(f"Build the slim image for {', '.join(platforms)}"):
        source, _ = engine.build(job, environment=variables)
    found: dict[str, SlimReport] = {}
    for image in registry.platforms(run.image, source, platform=platforms[0] if len(platforms) == 1 else None):
        disk.before_pull(image, environment)
        reference = f"{run.image}@{image.digest}"
        with workflow.group(f"Prove the slim image {reference} on {image.platform}"):
            registry.pull(reference, image.platform)
            report = _proved(run, reference, image.platform, screenshots)
            engine.remove_image(reference)
        size = sum(layer.size for layer in image.layers)
        found[image.platform] = replace(report, digest=image.digest, source=source, size=size)
    return found


def _loaded(  # noqa: PLR0917 - as above
    folder: Folder,
    run: Run,
    build: Mapping[str, str],
    platforms: tuple[str, ...],
    screenshots: Path,
    environment: Mapping[str, str],
) -> dict[str, SlimReport]:
    """Load one image after the other into the engine, and prove it."""
    job, variables = proving.again(folder, run, build, environment)
    found: dict[str, SlimReport] = {}
    for platform in platforms:
        candidate = runs.candidate(folder, run, platform) + tags.SLIM_ENDING
        with workflow.group(f"Build, load and prove the slim image on {platform}"):
            made = replace(job, platforms=(platform,), tags=(candidate,), target=SLIM)
            digest, _ = engine.build(made, environment=variables)
            found[platform] = replace(_proved(run, candidate, platform, screenshots), digest=digest)
            engine.remove_image(candidate)
    return found


def _proved(run: Run, reference: str, platform: str, screenshots: Path) -> SlimReport:
    shown = proving.attempt(run, reference, platform, screenshots)
    failure = shown.failure(run)
    return SlimReport(proofs=shown.reports, ladder=shown.ladder, failure=failure.message if failure else "")
