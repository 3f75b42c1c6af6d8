"""Packages that need no compiler, GPUs that each CUDA compiles for, and hosts that serve everything by https."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def prebuilt() -> frozenset[str]:
    """Return the packages of pip's index that have a wheel for each Python and platform, or hold no compiled code."""
    return frozenset(row["pip"] for row in rows("prebuilt"))


@cache
def without_nvcc() -> frozenset[str]:
    """Return the packages that people install from git, and that compile nothing for a GPU."""
    return frozenset(row["pip"] for row in rows("without_nvcc"))


@cache
def architectures() -> tuple[tuple[str, str], ...]:
    """Return ``(CUDA, value of TORCH_CUDA_ARCH_LIST)``: a row holds from its CUDA on."""
    return tuple((row["cuda"], row["architectures"]) for row in rows("cuda_architectures"))


def newest_gpu_of_torch(release: str) -> Version | None:
    """Return the newest GPU that a release of torch compiles extensions for: it stops at a newer one by name."""
    of = [(first, gpu) for first, gpu in _newest_gpus() if first <= Version(release)]
    return max(of)[1] if of else None


@cache
def _newest_gpus() -> tuple[tuple[Version, Version], ...]:
    return tuple((Version(row["torch"]), Version(row["newest"])) for row in rows("torch_architectures"))


@cache
def gpu_variables() -> dict[str, tuple[str, Version]]:
    """Return by package the variable of its own in which it is told the GPUs to compile for, and the lowest of them."""
    return {row["pip"]: (row["variable"], Version(row["lowest"])) for row in rows("gpu_variables")}


@cache
def gpu_options() -> dict[str, str]:
    """Return by package the option of its setup.py without which it is compiled for the CPU where no GPU is seen."""
    return {row["pip"]: row["option"] for row in rows("gpu_options")}


@cache
def public_hosts() -> frozenset[str]:
    """Return the hosts of public code whose every repository can be cloned by https."""
    return frozenset(row["host"] for row in rows("git_hosts"))


@cache
def programs() -> dict[str, str]:
    """Return the package of apt that has a program, by the program's name."""
    return {row["program"]: row["apt"] for row in rows("programs")}


@cache
def sources_need() -> dict[str, tuple[str, ...]]:
    """Return the apt packages that a pip package is compiled with where it has no wheel."""
    return {row["pip"]: tuple(row["apt"].split()) for row in rows("sources_need")}
