"""Proofs: running the built image on each platform of a job before it gets a tag."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.engine import docker as engine
from roslab.engine import gpu, registry
from roslab.errors import BuildError, Problem
from roslab.github import disk, explaining, locking, screen, secrets, tree, trial, workflow
from roslab.github import run as runs
from roslab.github.run import Folder, Run
from roslab.pipeline import POLICY
from roslab.plan.ladder import LOWER, Ladder, below
from roslab.plan.proof import describe
from roslab.prove import containers
from roslab.prove.ladder import climb
from roslab.render.outcome import PlatformReport, ProofReport
from roslab.render.sizes import LayerSize

OUTPUT_LINES = 200
"""Lines of a proof's output that are kept for the summary."""


def prove(environment: Mapping[str, str]) -> None:
    """Run the image on every platform of this job, one after the other. Raises ``BuildError`` if a proof fails."""
    folder = Folder.of(environment)
    run = folder.run
    build = json.loads(folder.read("build.json"))
    seconds = time.time() - build["started"]
    platforms = tuple(build["platforms"].split(","))
    digest = environment.get("ROSLAB_DIGEST", "")
    with screen.screenshots(folder, run, platforms, environment):
        if run.push:
            single = platforms[0] if len(platforms) == 1 else None
            images = registry.platforms(run.image, digest, platform=single)
            if sorted(image.platform for image in images) != sorted(platforms):
                found = ", ".join(image.platform for image in images)
                wanted = f"{', '.join(platforms)} were to be built, the registry holds {found}"
                raise BuildError(Problem(message=wanted))
            failed = []
            for image in images:
                disk.before_pull(image, environment)
                failed.append(_prove_pushed(folder, run, image, digest, seconds, environment))
        else:
            failed = [
                _prove_loaded(folder, run, platform, build, seconds, digest, environment) for platform in platforms
            ]
            trial.tell(folder, run, platforms, environment)
    if problems := [problem for problem in failed if problem]:
        raise BuildError(*problems)
    said = {name: build[name] for name in ("mounts", "source")}
    tree.keep(tree.Carrier(plan=run.plan, folder=folder.dockerfile, platforms=platforms, **said), build["tree"])


def _prove_pushed(  # noqa: PLR0917 - what one platform's image is proved with
    folder: Folder,
    run: Run,
    image: registry.PlatformImage,
    source: str,
    seconds: float,
    environment: Mapping[str, str],
) -> Problem | None:
    reference = f"{run.image}@{image.digest}"
    base = registry.base_layers(run.plan.base_image, image.platform)
    with workflow.group(f"Prove {reference} on {image.platform}"):
        registry.pull(reference, image.platform)
        given = _gpus(run)
        outcomes = containers.prove(
            reference,
            image.platform,
            run.plan.proofs,
            limits=run.plan.proof_limits,
            goals=run.plan.proof_goals,
            screenshots=folder.artifact,
            gpus=bool(given),
        )
        if run.lock and all(outcome.passed for outcome in outcomes):
            locking.keep(folder, run, reference, image.platform, environment.get("ROSLAB_METADATA", ""))
        engine.remove_image(reference)
    ladder = climb(run.plan.proofs, outcomes, run.plan.proof_goals, gpu=run.plan.run.gpu)
    for problem in disk.large_layers(run.image, [(layer.size, layer.created_by) for layer in image.layers]):
        workflow.warn(problem)
    layers = tuple(LayerSize(size=x.size, text=x.created_by, base=x.digest in base) for x in image.layers)
    folder.write_report(
        PlatformReport(
            platform=image.platform,
            digest=image.digest,
            source=source,
            layers=layers,
            proofs=_proofs(outcomes, given),
            ladder=ladder,
            build_seconds=seconds,
        )
    )
    return _failure(folder, run, outcomes, ladder, environment)


def _prove_loaded(  # noqa: PLR0917 - what one platform's build is made of
    folder: Folder,
    run: Run,
    platform: str,
    build: Mapping[str, str],
    seconds: float,
    digest: str,
    environment: Mapping[str, str],
) -> Problem | None:
    """Run one platform's image; if it is not loaded yet, load it from the builder, which still has all its layers.

    An image that people may try is kept as an archive once its proofs held.
    """
    candidate = runs.candidate(folder, run, platform)
    pairs = tuple((line.partition("=")[0], line.partition("=")[2]) for line in build["labels"].splitlines())
    authored = run.plan.author_dockerfile
    job = engine.Build(
        context=Path(build["context"]),
        dockerfile=Path(build["dockerfile"]),
        platforms=(platform,),
        tags=(candidate,),
        labels=pairs,
        arguments=authored.args if authored else (),
        target=authored.target if authored else None,
        secrets=secrets.held(folder, run, environment),
        extra=("--provenance=false",),
    )
    with workflow.group(f"Load and prove {platform}"):
        if not build["exporter"].startswith("type=docker,"):
            epoch = {"SOURCE_DATE_EPOCH": build["epoch"]} if build["epoch"] else {}
            policy = {POLICY: build["source-policy"]} if build["source-policy"] else {}
            digest, _ = engine.build(job, environment=epoch | policy)
        given = _gpus(run)
        outcomes = containers.prove(
            candidate,
            platform,
            run.plan.proofs,
            limits=run.plan.proof_limits,
            goals=run.plan.proof_goals,
            screenshots=folder.artifact,
            gpus=bool(given),
        )
        ladder = climb(run.plan.proofs, outcomes, run.plan.proof_goals, gpu=run.plan.run.gpu)
        failure = _failure(folder, run, outcomes, ladder, environment)
        platforms = build["platforms"].split(",")
        archive, remark = trial.keep(folder, run, platform, platforms, environment) if failure is None else (None, "")
        engine.remove_image(candidate)
    folder.write_report(
        PlatformReport(
            platform=platform,
            digest=digest,
            source="",
            layers=(),
            proofs=_proofs(outcomes, given),
            ladder=ladder,
            build_seconds=seconds,
            archive=archive,
            archive_remark=remark,
        )
    )
    return failure


def _gpus(run: Run) -> tuple[str, ...]:
    """Return the GPUs that a proof gets: all that the machine offers if the image needs one, otherwise none."""
    return gpu.usable() if run.plan.run.gpu else ()


def _proofs(outcomes: Sequence[containers.Outcome], gpus: Sequence[str]) -> tuple[ProofReport, ...]:
    """Return the reports of the proofs, with the GPU that each one used."""
    used = f", on {' and '.join(dict.fromkeys(gpus))}" if gpus else ""
    return tuple(
        ProofReport(
            name=outcome.proof.name,
            command=describe(outcome.proof) if outcome.proof.command else "",
            passed=outcome.passed,
            summary=f"{outcome.summary}{used}",
            output="\n".join(outcome.output.splitlines()[-OUTPUT_LINES:])[-20_000:],
            screenshot=outcome.screenshot.file.name if outcome.screenshot and outcome.screenshot.file else "",
            screenshot_remark=outcome.screenshot.remark if outcome.screenshot else "",
        )
        for outcome in outcomes
    )


def _failure(
    folder: Folder, run: Run, outcomes: Sequence[containers.Outcome], ladder: Ladder, environment: Mapping[str, str]
) -> Problem | None:
    """Return why the image is not given a tag: the proof that failed, or the rung that it did not reach."""
    failed = next((outcome for outcome in outcomes if not outcome.passed), None)
    if failed:
        hint = "correct the code, or name another `test` in roslab.yaml"
        failure = Problem(message=f"on {failed.platform}, {failed.proof.name}: {failed.summary}", hint=hint)
        return explaining.explain_proof(folder, failure, failed.output, environment)
    if short := below(ladder, run.plan.proof_goals.rung):
        return Problem(message=f"on {outcomes[0].platform}, {short}", hint=LOWER)
    return None
