"""For which platforms the image can exist."""

from __future__ import annotations

import re
from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.decision import Python, Reason
from roslab.decide.python.environment import specifiers
from roslab.decide.python.pins import name_of
from roslab.decide.reasons import configured
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distro
from roslab.knowledge.frameworks import arm64_wheels, framework, version

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


@dataclass(frozen=True, kw_only=True, slots=True)
class PlatformChoice:
    """Platforms to build, and ``(platform, why not)`` for those left out."""

    platforms: tuple[str, ...] = (AMD64, ARM64)
    refused: tuple[tuple[str, str], ...] = ()
    reasons: tuple[Reason, ...] = ()


def decide_platforms(  # noqa: PLR0917 - the order in which the questions are answered
    evidence: Evidence,
    config: Config,
    kind: Kind,
    base_image: str,
    ros_distro: str | None,
    cuda: str | None,
    python: Python,
) -> PlatformChoice:
    """Return the platforms that can exist: amd64 always, arm64 where the base, CUDA and every pinned wheel have it."""
    if config.platforms is not None:
        said = configured(config, "platforms", ", ".join(config.platforms), "platforms")
        return PlatformChoice(platforms=config.platforms, reasons=(said,))
    against = _against(evidence, kind, base_image, ros_distro, cuda, python)
    if against is None:
        both = Reason(
            question="platforms",
            answer=f"{AMD64}, {ARM64}",
            reason=f"{base_image} exists for both, and nothing speaks against it",
            weight=10,
        )
        return PlatformChoice(reasons=(both,))
    why, file, line = against
    reason = Reason(question="platforms", answer=AMD64, reason=f"no {ARM64}: {why}", file=file, line=line, weight=50)
    return PlatformChoice(platforms=(AMD64,), refused=((ARM64, why),), reasons=(reason,))


def _against(  # noqa: PLR0917
    evidence: Evidence, kind: Kind, base_image: str, ros_distro: str | None, cuda: str | None, python: Python
) -> tuple[str, str | None, int | None] | None:
    """Return why there can be no arm64 image, with the place that says so."""
    if match := _AMD64_ONLY.match(base_image):
        return f"{match[0].rstrip('/')} is published for amd64 only", None, None
    release = distro(ros_distro)
    if release is not None and not release.arm64:
        return f"ROS {release.name} was never built for arm64", None, None
    if base_image.startswith("nvidia/cuda") and version(cuda or "11.8") < _IMAGE_ARM64:
        return f"nvidia/cuda has no arm64 image of CUDA {cuda or '11.8'} for this Ubuntu", None, None
    frameworks = kind == "cuda" and python.manager != "system"
    if frameworks and version(cuda or "11.8") < _CUDA_ARM64:
        return f"frameworks have no arm64 wheels for CUDA {cuda or '11.8'}", None, None
    return _wheel(evidence, python) or _conda(evidence, python)


def _wheel(evidence: Evidence, python: Python) -> tuple[str, str | None, int | None] | None:
    where = {d.name: d for file in evidence.requirements for d in file.dependencies}
    where |= {d.name: d for project in evidence.python for d in project.dependencies}
    for line in specifiers(evidence, python):
        if line in python.pip_guessed:
            continue  # a guess that cannot be installed is reported, and breaks nothing
        name = name_of(line)
        place = where.get(line)
        file, number = (place.file, place.line) if place else (None, None)
        if re.search(r"(?:linux|manylinux\w*)_x86_64\.whl", line):
            return f"{name} is a wheel for amd64", file, number
        if name not in arm64_wheels():
            continue
        first = arm64_wheels()[name]
        if first is None:
            return f"{name} has no arm64 wheels", file, number
        exact = _EXACT.search(line)
        if exact and version(exact[1]) < version(first):
            return f"{name} has arm64 wheels from {first} on, {exact[1]} is pinned", file, number
    return None


def _conda(evidence: Evidence, python: Python) -> tuple[str, str | None, int | None] | None:
    for environment in evidence.conda:
        if environment.file == python.conda_file:
            for package in environment.packages:
                if _BUILD.match(package):
                    return f"{package} names a build for one platform", environment.file, 1
                if re.match(
                    r"^(?:[\w-]+::)?(?:cudatoolkit|pytorch-cuda|mkl|mujoco-py|pytorch3d|habitat-sim)\b", package
                ):
                    return f"conda has no arm64 package for {package}", environment.file, 1
    if python.manager == "conda" and framework("numpy", None) and version(python.version or "3.10") < (3, 7):
        return f"conda-forge has no arm64 build of Python {python.version}", None, None
    return None
