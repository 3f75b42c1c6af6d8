"""Dockerfiles under names of their own, in a folder of Dockerfiles: ``dockerfiles/base``, ``docker/ros-noetic``.

And definitions of Apptainer and Singularity.
"""

from __future__ import annotations

import re
from typing import Literal

from roslab.evidence.prose import definitions
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_FOLDER = pattern(r"\.?(?:docker|container)", re.IGNORECASE)
_PAGE = pattern(r"read_?me|license|notice|changelog|authors|copying", re.IGNORECASE)
_BEGINS = pattern(
    r"\s*(?:(?:#[^\n]*|ARG[ \t]+\w+(?:=[^\n]*)?)\n\s*)*"
    r"FROM[ \t]+(?:--\S+[ \t]+)?[\w.\-/:@${}]+(?:[ \t]+AS[ \t]+\S+)?[ \t]*(?:\n|$)",
    re.IGNORECASE,
)
"""ARG is all that may stand before FROM: https://docs.docker.com/reference/dockerfile/#from"""


def read(repository: Repository) -> list[File]:
    """Return definitions, and files without an ending in such folders that begin like a Dockerfile."""
    found = (file for file in repository.suffixed("") if "." not in file.name and 0 < file.size <= MAX_SIZE)
    named = [file for file in found if named_otherwise(file) and _BEGINS.match(repository.read(file))]
    return [*named, *definitions.read(repository)]


def text_of(repository: Repository, file: File, limit: int) -> str:
    """Return the text of a Dockerfile, or the one that a definition amounts to."""
    text = repository.read(file, limit=limit)
    return definitions.as_dockerfile(text) if definitions.is_definition(file.path) else text


def source_of(path: str) -> Literal["dockerfile", "script"]:
    """Return what a file is quoted as: a definition of an image tells less than a Dockerfile."""
    return "script" if definitions.is_definition(path) else "dockerfile"


def named_otherwise(file: File) -> bool:
    """Tell whether a file in a folder of Dockerfiles is not named like one."""
    folder = file.folder.rpartition("/")[2]
    name = file.name.lower()
    usual = "dockerfile" in name or name == "containerfile" or bool(_PAGE.match(name))
    return bool(_FOLDER.match(folder)) and not usual
