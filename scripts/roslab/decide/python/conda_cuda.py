"""The CUDA for which conda solves an environment: while an image is built there is no driver that tells it."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.cuda.version import OF_CONDA
from roslab.evidence.facts import Evidence
from roslab.values.version import Version, minor_of


def cuda_of_conda(evidence: Evidence, kind: Kind, file: str | None, cuda: str | None) -> str:
    """Return the version that ``__cuda`` stands for: the base's, or a newer one that the ``file`` names; else ``""``.

    Without it conda takes builds for the CPU wherever one for the GPU asks for a driver.
    https://docs.conda.io/projects/conda/en/stable/user-guide/tasks/manage-virtual.html, read 2026-11-25.
    """
    if kind != "cuda" or not cuda:
        return ""
    packages = [package for each in evidence.conda if each.file == file for package in each.packages]
    named = [minor_of(package.version) for package in packages if package.name in OF_CONDA]
    return max((cuda, *(each for each in named if each)), key=Version)
