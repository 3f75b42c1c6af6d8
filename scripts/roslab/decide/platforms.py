"""For which platforms the image can exist."""

from __future__ import annotations

import re
from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.decision import Choice, Python
from roslab.decide.python.environment import specifiers
from roslab.decide.python.pins import name_of
from roslab.decide.reasons import because, configured
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distro
from roslab.knowledge.frameworks import arm64_wheels, version
from roslab.values.origin import Place

AMD64, ARM64 = "linux/amd64", "linux/arm64"
_AMD64_ONLY = re.compile(
    r"^(?:osrf/ros|nvidia/cudagl|nvidia/opengl|continuumio/miniconda3:4\.[0-8]|stereolabs/|carlasim/)"
)
_EXACT = re.compile(r"={2,3}\s*(\d[\w.]*)")
_BUILD = re.compile(r"^[\w-]+=[\w.]+=\w+$")
_CUDA_ARM64 = (12, 8)
"""First CUDA with arm64 wheels of torch on the index. https://pytorch.org/blog/pytorch-2-7/, read 2026-08-22."""

_IMAGE_ARM64 = (12, 0)
"""From here on every image is published for both. https://hub.docker.com/r/nvidia/cuda/tags, read 2026-08-22."""


class Weight:
    """What speaks for a choice of platforms."""

    AGAINST = 50  # one thing that has no arm64 is enough
    NOTHING_AGAINST = 10


@dataclass(frozen=True, kw_only=True, slots=True)
class Platforms:
    """Platforms to build, and ``(platform, why not)`` for those left out."""

    built: tuple[str, ...] = (AMD64, ARM64)
    refused: tuple[tuple[str, str], ...] = ()


Against = tuple[str, Place | None]
"""Why there can be no image for a platform, and where that stands."""


def decide_platforms(  # noqa: PLR0917 - the order in which the questions are answered
    evidence: Evidence,
    config: Config,
    kind: Kind,
    base_image: str,
    ros_distro: str | None,
    cuda: str | None,
    python: Python,
) -> Choice[Platforms]:
    """Return the platforms that can exist: amd64 always, arm64 where the base, CUDA and every pinned wheel have it."""
    if config.platforms is not None:
        said = configured(config, "platforms", ", ".join(config.platforms), "platforms")
        return Choice(answer=Platforms(built=config.platforms), reasons=(said,))
    against = _against(evidence, kind, base_image, ros_distro, cuda, python)
    if against is None:
        why = f"{base_image} exists for both, and nothing speaks against it"
        both = because("platforms", f"{AMD64}, {ARM64}", why, weight=Weight.NOTHING_AGAINST)
        return Choice(answer=Platforms(), reasons=(both,))
    why, place = against
    one = because("platforms", AMD64, f"no {ARM64}: {why}", place, weight=Weight.AGAINST)
    return Choice(answer=Platforms(built=(AMD64,), refused=((ARM64, why),)), reasons=(one,))


def _against(  # noqa: PLR0917
    evidence: Evidence, kind: Kind, base_image: str, ros_distro: str | None, cuda: str | None, python: Python
) -> Against | None:
    """Return the first thing that has no arm64: the base image, ROS, CUDA, a wheel or a package of conda."""
    if match := _AMD64_ONLY.match(base_image):
        return f"{match[0].rstrip('/')} is published for amd64 only", None
    release = distro(ros_distro)
    if release is not None and not release.arm64:
        return f"ROS {release.name} was never built for arm64", None
    if base_image.startswith("nvidia/cuda") and version(cuda or "11.8") < _IMAGE_ARM64:
        return f"nvidia/cuda has no arm64 image of CUDA {cuda or '11.8'} for this Ubuntu", None
    frameworks = kind == "cuda" and python.manager != "system"
    if frameworks and version(cuda or "11.8") < _CUDA_ARM64:
        return f"frameworks have no arm64 wheels for CUDA {cuda or '11.8'}", None
    return _wheel(evidence, python) or _conda(evidence, python)


def _wheel(evidence: Evidence, python: Python) -> Against | None:
    where = {d.name: d for file in evidence.requirements for d in file.dependencies}
    where |= {d.name: d for project in evidence.python for d in project.dependencies}
    for line in specifiers(evidence, python):
        if line in python.pip_guessed:
            continue  # a guess that cannot be installed is reported, and breaks nothing
        name = name_of(line)
        asked = where.get(line)
        place = Place(file=asked.file, line=asked.line) if asked else None
        if re.search(r"(?:linux|manylinux\w*)_x86_64\.whl", line):
            return f"{name} is a wheel for amd64", place
        if name not in arm64_wheels():
            continue
        first = arm64_wheels()[name]
        if first is None:
            return f"{name} has no arm64 wheels", place
        exact = _EXACT.search(line)
        if exact and version(exact[1]) < version(first):
            return f"{name} has arm64 wheels from {first} on, {exact[1]} is pinned", place
    return None


def _conda(evidence: Evidence, python: Python) -> Against | None:
    for environment in evidence.conda:
        if environment.file == python.conda_file:
            for package in environment.packages:
                if _BUILD.match(package):
                    return f"{package} names a build for one platform", Place(file=environment.file, line=1)
                if re.match(
                    r"^(?:[\w-]+::)?(?:cudatoolkit|pytorch-cuda|mkl|mujoco-py|pytorch3d|habitat-sim)\b", package
                ):
                    return f"conda has no arm64 package for {package}", Place(file=environment.file, line=1)
    if python.manager == "conda" and version(python.version or "3.10") < (3, 7):
        return f"conda-forge has no arm64 build of Python {python.version}", None
    return None
