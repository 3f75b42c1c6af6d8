"""Disk space for an image: estimate the least it needs before the build, and free space if that is allowed.

A runner stores an image more than once: compressed and unpacked in BuildKit's store, and again in the store of the
engine that runs it. GitHub's own runners have about 14 GB free.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from roslab.engine import disk, registry
from roslab.errors import BuildError, Problem
from roslab.github import workflow
from roslab.github.run import Run
from roslab.knowledge.runner_weight import runner_weight
from roslab.plan.plan import Plan
from roslab.values.pattern import pattern

GB = 10**9
UNPACKED = 2
"""Least ratio of unpacked to compressed size of a layer: measured 2.8 for ROS and Python, 4 for a minimal base."""
PACKAGES = 4 * GB
"""Bytes for what is installed on the base, if nothing heavier is known."""
FRAMEWORK = 12 * GB
"""Bytes for a framework with its CUDA libraries: 3 GB of wheels, unpacked, then compressed as a layer."""
HEAVY = pattern(r"(?:torch|tensorflow|jax|paddlepaddle|mxnet|tensorrt|nvidia-\w+)\b", re.IGNORECASE)
LARGER = "take a larger runner (the input runners), or a smaller base (base.image in roslab.yaml)"


LARGEST_LAYER = 10 * GB
"""Compressed bytes of a layer that ghcr.io takes at most.
https://docs.github.com/en/packages/working-with-a-github-packages-registry/working-with-the-container-registry"""
NEAR = 0.8
"""Part of that from which on a layer is told."""


def large_layers(name: str, layers: Sequence[tuple[int, str]]) -> tuple[Problem, ...]:
    """Return a problem for each layer of an image of ghcr.io that is nearly too large for it.

    ``layers`` are compressed bytes and what made each.
    """
    if not name.startswith("ghcr.io/"):
        return ()
    hint = "spread what it installs over several steps: keys of roslab.yaml, or RUN of a Dockerfile"
    return tuple(
        Problem(
            message=f"a layer of {_gb(size)} is near the {_gb(LARGEST_LAYER)} that ghcr.io takes: {made}", hint=hint
        )
        for size, made in layers
        if size > NEAR * LARGEST_LAYER
    )


def before_build(run: Run, platforms: Sequence[str], environment: Mapping[str, str]) -> None:
    """Print how much disk space is free and needed, and free some on GitHub's own runners.

    Raises ``BuildError`` if the base image alone cannot fit.
    """
    available = disk.free()
    if available is None:
        return
    base = sum(registry.base_size(run.plan.base_image, platform) for platform in platforms)
    least = base * (1 + UNPACKED)
    wanted = 2 * least + (FRAMEWORK if _heavy(run.plan) else PACKAGES)
    known = f"{run.plan.base_image} needs at least {_gb(least)}" if base else "the base image's size is not known"
    workflow.say(f"disk: {_gb(available)} free; {known}, the whole build about {_gb(wanted)}")
    if available < wanted and environment.get("RUNNER_ENVIRONMENT") == "github-hosted":
        available = make_room(wanted)
    if available < least:
        message = f"{run.plan.base_image} alone needs about {_gb(least)}, and {_gb(available)} are free on this runner"
        raise BuildError(Problem(message=message, hint=LARGER))


def make_room(wanted: int, weights: Sequence[tuple[str, str]] | None = None) -> int:
    """Remove preinstalled software, the largest first, until enough is free; return the bytes that are free then."""
    available = disk.free() or 0
    with workflow.group("Make room on the runner"):
        for folder, holds in runner_weight() if weights is None else weights:
            if available >= wanted:
                break
            if disk.remove(folder):
                before, available = available, disk.free() or 0
                workflow.say(
                    f"removed {folder} ({holds}): {_gb(max(0, available - before))} more, {_gb(available)} free"
                )
    return available


def before_pull(image: registry.PlatformImage, environment: Mapping[str, str]) -> None:
    """Free space for a pushed image that the engine will run.

    Raises ``BuildError`` if it cannot fit.
    """
    available = disk.free()
    size = sum(layer.size for layer in image.layers)
    needed = size * (1 + UNPACKED)
    if available is None or available >= needed + GB:
        return
    if owns_builder(environment):
        workflow.say(f"disk: {_gb(available)} free, {_gb(needed)} are needed: BuildKit's store is emptied")
        disk.prune()
        available = disk.free() or 0
        workflow.say(f"disk: {_gb(available)} free")
    if available < size * UNPACKED:
        message = f"the image was built and needs about {_gb(needed)} to be run, and {_gb(available)} are free"
        raise BuildError(Problem(message=message, hint=LARGER))


def owns_builder(environment: Mapping[str, str]) -> bool:
    """Return whether only this job uses the builder: one that the machine's owner named may serve others.

    ROSLAB_BUILDX_PRUNE (``true``) allows emptying a named builder too.
    """
    return not environment.get("ROSLAB_BUILDX_DRIVER") or environment.get("ROSLAB_BUILDX_PRUNE") == "true"


def _heavy(plan: Plan) -> bool:
    lines = (*plan.python.pip, *plan.python.first, *plan.python.pip_guessed)
    return plan.run.gpu or plan.kind == "cuda" or any(HEAVY.match(line) for line in lines)


def _gb(size: int) -> str:
    return f"{size / GB:.1f} GB"
