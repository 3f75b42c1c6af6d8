"""A repository of the protected registry that has the layers of what most tests build from.

Else a push sends them each time, 63 MB for each platform. BuildKit has the registry take a layer from another
repository to which it was pushed, but asks for one alone, the last by name of those with the same owner, which went
with the store of an earlier registry (``selectRepositoryMountCandidate`` of containerd). This one is the last, and made
with each store.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence

from . import buildkit, registry
from .command import run

OWNERS = ("lab", "someone", "demo")
"""Of the repositories that are pushed most."""
NAME = "zz-bases"
BASE = "ubuntu:24.04"
DOCKERFILE = f"FROM {BASE}\nRUN :\n"
"""With a step: what is not unpacked is not kept, and nothing is noted of it."""


def up(environment: Mapping[str, str], architectures: Sequence[str]) -> str:
    """Push the base's layers for each owner, unless the registry has them."""
    names = [f"{owner}/{NAME}" for owner in OWNERS]
    tag = "-".join(architectures)
    if all(registry.digest(f"{name}:{tag}") for name in names):
        return "is there"
    platforms = ",".join(f"linux/{architecture}" for architecture in architectures)
    with tempfile.TemporaryDirectory() as folder:
        env = {**environment, "BUILDX_CONFIG": folder}
        run(["docker", "buildx", "create", "--name", "mounts", "--driver", "remote", buildkit.address()], env=env)
        for name in names:
            image = f"{registry.address(registry.PROTECTED)}/{name}:{tag}"
            words = [
                "--builder",
                "mounts",
                "--platform",
                platforms,
                "--tag",
                image,
                "--push",
                "--provenance=false",
                "-",
            ]
            run(["docker", "buildx", "build", *words], env=env, stdin=DOCKERFILE)
    return "made"
