"""The CUDA image for a wheel of torch that brings its own CUDA: of the same version, where one exists."""

from __future__ import annotations

from roslab.knowledge.frameworks import Framework, cuda_image, nearest_cuda_image
from roslab.values.version import Version

_OF_AMPERE = Version("11")
"""Wheels for an older CUDA have no code for GPUs since Ampere.

https://docs.nvidia.com/cuda/ampere-compatibility-guide/, read 2026-11-27."""


def of_wheel(row: Framework) -> tuple[str, str]:
    """Return the CUDA of the image for a release that nothing pins, and what is said of it where it is another one.

    Of an old release it is that of the wheel which knows newer GPUs, as this is what pip is told to take.
    """
    own, *others = row.cuda
    newer = [each for each in others if Version(each) >= _OF_AMPERE]
    taken = max(newer, key=Version) if newer and Version(own) < _OF_AMPERE else own
    image = cuda_image(taken)
    if image and image.tag:
        return taken, f"CUDA {taken}"
    instead = nearest_cuda_image(taken).cuda
    return instead, f"CUDA {taken}, of which no image exists: it brings its own, and {instead} is the nearest"
