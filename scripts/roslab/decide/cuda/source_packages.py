"""Pinned packages that pip compiles, with a CUDA that is newer than what their release knows."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.cuda.version import Cuda
from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement
from roslab.values.version import Version


def with_too_old_sources(cuda: Choice[Cuda], installed: Iterable[Requirement]) -> Choice[Cuda]:
    """Return the choice with a warning for each such package: what the image has no older CUDA for cannot be built."""
    from roslab.knowledge.cuda_sources import newest_cuda  # noqa: PLC0415 - few trees need CUDA

    version = cuda.answer.version
    pinned = {(each.key, each.release): each for each in installed if each.release and not each.url} if version else {}
    told = []
    for (name, release), asked in pinned.items():
        newest = newest_cuda(name, release or "")
        if version and newest and newest < Version(version):
            why = (
                f"{asked.written} has no wheel, and its source knows CUDA up to {newest}, while the image has {version}"
            )
            instead = f"require {name}'s wheel for that CUDA instead, or set base.image in roslab.yaml"
            told.append(warn(f"{why}: pip stops there; {instead}", asked))
    return replace(cuda, warnings=(*cuda.warnings, *told)) if told else cuda
