"""What an author's Dockerfile is for."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Literal

from roslab.evidence import places
from roslab.evidence.lex.dockerfile import Instruction
from roslab.evidence.prose.definitions import is_definition
from roslab.evidence.service import Service
from roslab.repository.checkout import Repository
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
_REMOVES = pattern(r"[ \t]*rm((?:[ \t]+-\S+)*)((?:[ \t]+[\w.][\w./-]*)+)[ \t]*(?:$|[;\n]|&&)")


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


def removes_absent(repository: Repository, written: Iterable[Instruction], copied: int) -> str | None:
    """Return why a build of a clean checkout stops: the first step after the copy removes what it does not hold.

    ``written``: the instructions, ``copied``: the line of the copy of the whole repository, into the folder where the
    steps run. ``rm -f`` takes what is not there as well.
    """
    step = next((each for each in written if each.name == "RUN" and each.line > copied), None)
    match = _REMOVES.match(step.text) if step else None
    if step is None or match is None or "f" in match[1]:
        return None
    names = (name.rstrip("/") for name in match[2].split())
    gone = next((name for name in names if not repository.may_have(name)), None)
    return f"line {step.line} removes {gone}, which the repository does not hold, and stops there" if gone else None
