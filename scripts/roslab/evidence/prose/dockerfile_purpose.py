"""What an author's Dockerfile is for."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Literal

from roslab.evidence import places
from roslab.evidence.prose.definitions import is_definition
from roslab.evidence.service import Service
from roslab.values.pattern import pattern

_MACHINE = pattern(r"jetson|l4t|tegra|raspberry|\brpi\b|arm64|aarch64|armhf|\bursim\b", re.IGNORECASE)
_DEPLOY = pattern(r"deploy|production|release|simulator", re.IGNORECASE)
"""Unless a page at the root has Docker Compose start it."""
_CI = pattern(
    r"(?:^|[/._-])ci(?:[/._-]|$)|\.circleci|\.?devcontainer|\.github|\.gitlab|jenkins|travis|azure|clang-tidy|"
    r"coverage|lint",
    re.IGNORECASE,
)
_DOCS = pattern(r"sphinx|mkdocs|doxygen|jekyll|readthedocs|(?:^|[/._-])docs?(?:[/._-]|$)", re.IGNORECASE)
_INSTALLS = pattern(
    r"\b(?:make|ninja|setup\.py|pip\d?|catkin_make)\b[^;&|\n]*\binstall\b|--install\b|\b(?:cp|mv|colcon|catkin)[ \t]"
)
"""What leaves something of a compilation outside its folder."""


def purpose_of(
    path: str, base: str, problem: str | None, service: Service | None = None
) -> Literal["project", "documentation", "vendored", "ci", "deploy", "broken"]:
    """Return what a Dockerfile at a path with this base is for; one with a problem is broken.

    What a definition of Singularity or Apptainer sets up is an environment, as that of CI is: no image is made with it.

    ``service``: that of Docker Compose which a page has started from it, if any.
    """
    definition = is_definition(path)
    if problem and not (definition and base):
        return "broken"
    if places.vendored(path):
        return "vendored"
    if places.documentation(path) or _DOCS.search(path):
        return "documentation"
    if _CI.search(path):
        return "ci"
    if (
        _MACHINE.search(path)
        or (service is None and _DEPLOY.search(path))
        or re.search(r"l4t|jetson|arm32v7|arm64v8|ursim", base)
    ):
        return "deploy"
    return "ci" if definition else "project"


def removes_its_copy(runs: Iterable[str], source: str | None) -> bool:
    """Tell whether a Dockerfile removes its copy of the repository again and installs nothing: it tries to compile it.

    ``runs``: the texts of its RUN instructions, ``source``: the folder of the copy, as it is written.
    """
    text = "\n".join(runs)
    if not source or source.strip("/.") == "" or _INSTALLS.search(text):
        return False
    # What a variable in the path holds is not known: it is compared as it is written.
    folder = (source.removeprefix("/") if "$" in source else source).rstrip("/")
    return bool(re.search(rf"\brm[ \t]+(?:-\S+[ \t]+)+[\"']?{re.escape(folder)}/?[\"']?(?=\s|[;&]|$)", text))
