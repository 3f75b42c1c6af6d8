"""Proofs: running the built image on each platform of a job before it gets a tag."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from pathlib import Path

from roslab.engine import docker as engine
from roslab.engine import gpu, registry
from roslab.errors import BuildError, Problem
from roslab.github import disk, explaining, locking, screen, secrets, tree, trial, workflow
from roslab.github import run as runs
from roslab.github.run import Folder, Run
from roslab.pipeline import POLICY
from roslab.plan.ladder import LOWER, Ladder, below, missed
from roslab.plan.proof import describe
from roslab.prove import containers
from roslab.prove.ladder import climb
from roslab.render.outcome import PlatformReport, ProofReport
from roslab.render.sizes import LayerSize
from roslab.values.dataclass import dataclass, replace

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


@dataclass(frozen=True, kw_only=True, slots=True)
class Attempt:
    """What the proofs of one image showed."""

    outcomes: tuple[containers.Outcome, ...]
    ladder: Ladder
    gpus: tuple[str, ...]

    @property
    def reports(self) -> tuple[ProofReport, ...]:
        """The reports of the proofs, with the GPU that each one used."""
        used = f", on {' and '.join(dict.fromkeys(self.gpus))}" if self.gpus else ""
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
            for outcome in self.outcomes
        )

    @property
    def failed(self) -> containers.Outcome | None:
        """The proof that failed."""
        return next((outcome for outcome in self.outcomes if not outcome.passed), None)

    @property
    def dead(self) -> containers.Outcome | None:
        """The proof of the default command, where that died."""
        starts = (outcome for outcome in self.outcomes if outcome.proof.rung == 1)
        return next(starts, None) if missed(self.ladder, 1) else None

    def failure(self, run: Run) -> Problem | None:
        """Return why the image is not given a tag: the proof that failed, or the rung that it did not reach."""
        if failed := self.failed:
            hint = "correct the code, or name another `test` in roslab.yaml"
            return Problem(message=f"on {failed.platform}, {failed.proof.name}: {failed.summary}", hint=hint)
        if short := below(self.ladder, run.plan.proof_goals.rung):
            return Problem(message=f"on {self.outcomes[0].platform}, {short}", hint=LOWER)
        return None


def attempt(run: Run, reference: str, platform: str, screenshots: Path) -> Attempt:
    """Run an image that the engine holds, with the GPUs that the machine offers if it needs one."""
    gpus = gpu.usable() if run.plan.run.gpu else ()
    outcomes = containers.prove(
        reference,
        platform,
        run.plan.proofs,
        limits=run.plan.proof_limits,
        goals=run.plan.proof_goals,
        screenshots=screenshots,
        gpus=bool(gpus),
    )
    ladder = climb(run.plan.proofs, outcomes, run.plan.proof_goals, gpu=run.plan.run.gpu)
    return Attempt(outcomes=tuple(outcomes), ladder=ladder, gpus=tuple(gpus))


def again(
    folder: Folder, run: Run, build: Mapping[str, str], environment: Mapping[str, str]
) -> tuple[engine.Build, dict[str, str]]:
    """Return the build that an earlier step made, and its variables, for one that finds its layers in the builder."""
    job = engine.Build(
        context=Path(build["context"]),
        dockerfile=Path(build["dockerfile"]),
        labels=_pairs(build["labels"]),
        arguments=_pairs(build["build-args"]),
        contexts=_pairs(build["build-contexts"]),
        target=build["target"] or None,
        secrets=secrets.held(folder, run, environment),
        extra=("--provenance=false",),
    )
    epoch = {"SOURCE_DATE_EPOCH": build["epoch"]} if build["epoch"] else {}
    return job, epoch | ({POLICY: build["source-policy"]} if build["source-policy"] else {})


def _pairs(lines: str) -> tuple[tuple[str, str], ...]:
    return tuple((line.partition("=")[0], line.partition("=")[2]) for line in lines.splitlines())


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
        shown = attempt(run, reference, image.platform, folder.artifact)
        if run.lock and not shown.failed:
            locking.keep(folder, run, reference, image.platform, environment.get("ROSLAB_METADATA", ""))
        engine.remove_image(reference)
    _tell_start(folder, run, shown, environment)
    for problem in disk.large_layers(run.image, [(layer.size, layer.created_by) for layer in image.layers]):
        workflow.warn(problem)
    layers = tuple(LayerSize(size=x.size, text=x.created_by, base=x.digest in base) for x in image.layers)
    folder.write_report(
        PlatformReport(
            platform=image.platform,
            digest=image.digest,
            source=source,
            layers=layers,
            proofs=shown.reports,
            ladder=shown.ladder,
            build_seconds=seconds,
        )
    )
    return _failure(folder, run, shown, environment)


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
    with workflow.group(f"Load and prove {platform}"):
        if not build["exporter"].startswith("type=docker,"):
            job, variables = again(folder, run, build, environment)
            digest, _ = engine.build(replace(job, platforms=(platform,), tags=(candidate,)), environment=variables)
        shown = attempt(run, candidate, platform, folder.artifact)
        failure = _failure(folder, run, shown, environment)
        platforms = build["platforms"].split(",")
        archive, remark = trial.keep(folder, run, platform, platforms, environment) if failure is None else (None, "")
        engine.remove_image(candidate)
    _tell_start(folder, run, shown, environment)
    folder.write_report(
        PlatformReport(
            platform=platform,
            digest=digest,
            source="",
            layers=(),
            proofs=shown.reports,
            ladder=shown.ladder,
            build_seconds=seconds,
            archive=archive,
            archive_remark=remark,
        )
    )
    return failure


def _failure(folder: Folder, run: Run, shown: Attempt, environment: Mapping[str, str]) -> Problem | None:
    """Return why the image is not given a tag, with what its proof's output tells of the cause."""
    failure = shown.failure(run)
    told = shown.failed or shown.dead
    if failure and told:
        return explaining.explain_proof(folder, failure, told.output, environment)
    return failure


def _tell_start(folder: Folder, run: Run, shown: Attempt, environment: Mapping[str, str]) -> None:
    """Tell why the default command of an image died that is good enough without it."""
    if shown.dead and shown.failure(run) is None:
        explaining.explain_start(folder, shown.dead.platform, shown.dead.output, environment)
