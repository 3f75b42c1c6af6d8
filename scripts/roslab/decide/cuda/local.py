"""The CUDA that a wheel's local version, its URL or its index is for."""

from __future__ import annotations

from roslab.values.pattern import pattern

_LOCAL = pattern(r"\+cu(\d{2,3})\b|/cu(\d{2,3})\b|[-_]cu(?:da)?(\d{2,3})\b")
_BUILD = pattern(r"(?:^|[-_])cu(?:da)?(?:(\d+\.\d+)|(\d{2,3})(?!\d))")


def cuda_of_build(build: str) -> str | None:
    """Return ``11.1`` of the build string of a package of conda: ``py3.9_cuda11.1_cudnn8.0.5_0``, ``cuda111py39h…``."""
    match = _BUILD.search(build)
    digits = match[2] if match else None
    return f"{digits[:-1]}.{digits[-1]}" if digits else (match[1] if match else None)


def cuda_of(text: str) -> str | None:
    """Return ``11.8`` if a release, a URL or a pip option has ``+cu118`` or ``/cu118`` in it."""
    match = _LOCAL.search(text)
    digits = next((group for group in match.groups() if group), "") if match else ""
    return f"{digits[:-1]}.{digits[-1]}" if digits else None


def of_the_cpu(release: str) -> bool:
    """Tell whether a release is a build for the CPU alone: ``1.13.1+cpu``."""
    return release.lower().endswith("+cpu")
