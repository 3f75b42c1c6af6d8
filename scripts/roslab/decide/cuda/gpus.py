"""The CUDA versions whose compiler knows every GPU that the code is compiled for."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Reason, Warning_
from roslab.decide.reasons import because, warn
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.facts import Evidence
from roslab.knowledge.cuda_gpus import NAME
from roslab.knowledge.frameworks import cuda_images
from roslab.values.version import Version


def gpu_limits(evidence: Evidence) -> tuple[CodeLimit, ...]:
    """Return what the code says of the toolkit's version."""
    return tuple(limit for limit in evidence.limits if limit.library == NAME)


def knows_gpus(cuda: str, limits: Iterable[CodeLimit]) -> bool:
    """Tell whether a version lies within all limits."""
    number = Version(cuda)
    return all(
        (limit.at_least is None or number >= Version(limit.at_least))
        and (limit.below is None or number < Version(limit.below))
        for limit in limits
    )


def nearest_that_knows(asked: Reason, limits: tuple[CodeLimit, ...]) -> Reason | None:
    """Return the reason for the nearest CUDA with images whose compiler knows the GPUs, ``None`` if there is none."""
    images = [image.cuda for image in cuda_images() if image.tag and knows_gpus(image.cuda, limits)]
    if not images:
        return None
    newer = [cuda for cuda in images if Version(cuda) >= Version(asked.answer)]
    nearest = newer[0] if newer else images[-1]
    limit = next(each for each in limits if not knows_gpus(asked.answer, (each,)))
    why = f"the code is compiled for {limit.what}, which the compiler of CUDA {asked.answer} does not know"
    return because("cuda", nearest, why, limit, weight=asked.weight + 1)


def unknown_gpu(cuda: str | None, limits: Iterable[CodeLimit]) -> Warning_ | None:
    """Return a warning about the first GPU that the compiler of the chosen CUDA does not know."""
    limit = next((each for each in limits if cuda and not knows_gpus(cuda, (each,))), None)
    if limit is None:
        return None
    message = f"the code is compiled for {limit.what}, and the compiler of CUDA {cuda} does not know it"
    return warn(
        f"{message}: it stops there; no image has one that knows all GPUs of the code, so change the line", limit
    )
