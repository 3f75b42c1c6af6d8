"""The options for CUDA with which a page has a library compiled: an image without CUDA cannot follow them."""

from __future__ import annotations

import shlex
from collections.abc import Iterable

from roslab.config.model import Source
from roslab.evidence.dependency import Dependency
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_FOR_CUDA = pattern(r"-D\w*(?:CUDA|CUDNN|CUBLAS|CUFFT|NVCUVID|NVCUVENC|NVCC)\w*(?::\w+)?=(?!(?:OFF|FALSE|NO|0)$)")
"""https://docs.opencv.org/4.x/db/d05/tutorial_config_reference.html, read 2026-11-26: OpenCV has most of them."""


def without_cuda(libraries: Iterable[tuple[Source, Dependency]]) -> tuple[tuple[Source, Dependency], ...]:
    """Return the libraries without the options that turn CUDA on or set it up; what turns it off stays."""
    return tuple((_without(source), asked) for source, asked in libraries)


def _without(source: Source) -> Source:
    words = shlex.split(source.cmake_options)
    kept = [word for word in words if not _FOR_CUDA.match(word)]
    return source if kept == words else replace(source, cmake_options=shlex.join(kept))
