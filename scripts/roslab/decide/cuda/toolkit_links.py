"""Folders of other releases of CUDA that files of CMake name: links lead to the toolkit that the image has."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.native.cuda_paths import FOLDER
from roslab.values.pattern import pattern

TOOLKIT = "/usr/local/cuda"
"""Where NVIDIA's images have theirs, whatever its release is."""
_IMAGE = pattern(r"(?:docker\.io/|nvcr\.io/)?nvidia/cuda(?:gl)?:(\d+\.\d+)")


def toolkit_links(evidence: Evidence, image: str) -> Iterator[tuple[str, Mention]]:
    """Yield each such folder that an image of NVIDIA's does not have, with what names it."""
    own = _IMAGE.match(image)
    for said in evidence.mentions if own else ():
        if said.topic == "cuda_path" and own and said.value != own[1]:
            yield f"{FOLDER}{said.value}", said
