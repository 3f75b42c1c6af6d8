"""Builds the images that replace those of an author's Dockerfile, and hands them to its build as named contexts."""

from __future__ import annotations

import re
import uuid
from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.engine import docker
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Mended:
    """The replacements of one build, and what is left in the engine when it is done."""

    contexts: tuple[tuple[str, str], ...] = ()
    """Pairs of ``--build-context``: the name in FROM, and what stands for it."""
    images: tuple[str, ...] = ()
    """Images in the engine, to be removed after the build."""


def mend(
    stages: Sequence[tuple[str, str]],
    dockerfile: Path,
    *,
    platforms: tuple[str, ...],
    options: Mapping[str, tuple[str, ...]] | None = None,
    environment: Mapping[str, str] | None = None,
) -> Mended:
    """Build each ``(stage, name in FROM)`` of a Dockerfile that needs no context.

    ``options`` are more words of ``docker buildx build`` for a stage. The engine's own builder finds an image that the
    engine holds; any other gets the files of the image, in the folder of the Dockerfile. Raises ``FailedBuild``.
    """
    own = driver() == "docker"
    contexts, images = [], []
    for stage, name in stages:
        docker.say(f"roslab: {name} is replaced, by {stage} of {dockerfile.name}")
        layout = dockerfile.parent / stage
        image = f"roslab-{stage}:{uuid.uuid4().hex[:12]}"
        job = docker.Build(
            context=dockerfile.parent,
            dockerfile=dockerfile,
            platforms=platforms,
            tags=(image,) if own else (),
            target=stage,
            output="" if own else f"type=oci,tar=false,dest={layout}",
            extra=("--provenance=false", *(options or {}).get(stage, ())),
        )
        digest, _ = docker.build(job, environment=environment)
        contexts.append((name, f"docker-image://{image}" if own else f"oci-layout://{layout}@{digest}"))
        images += [image] if own else []
    return Mended(contexts=tuple(contexts), images=tuple(images))


def driver() -> str:
    """Return the driver of the builder in use, ``docker`` for the engine's own."""
    found = re.search(r"^Driver:\s*(\S+)", docker.output(["docker", "buildx", "inspect"]).stdout, re.MULTILINE)
    return found[1] if found else "docker"
