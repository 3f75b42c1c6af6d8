"""Variables that a page exports with a place in the tree, or in the folder in ``/opt`` of a package."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping
from typing import Literal

from roslab.evidence.facts import Mention
from roslab.evidence.prose.python_path import DEEPEST, HERE
from roslab.evidence.ros.vcs import submodules
from roslab.repository.checkout import File, Repository
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

OPT = "/opt/"
PYTHON = "$PYTHON"
"""What stands for the version of Python in a path."""
_EXPORT = pattern(
    r"^[ \t$>]*export[ \t]+([A-Z][A-Z0-9_]{2,40})=([^\n`;&|]{1,300}?)[ \t]*(?:[ \t]#[^\n]*)?$", re.MULTILINE
)
_BLANK = pattern(r"\[([A-Za-z][\w .-]{0,40})\]|<([A-Za-z][\w .-]{0,40})>|\{([A-Za-z][\w .-]{0,40})\}")
_REPOSITORY = pattern(r"\b(?:repo|repository|clone|root of this)\b", re.IGNORECASE)
_USED = pattern(r"\$\{(\w+)\}|\$(\w+)")
_PYTHON = pattern(r"python\$\(python3? -c [^\n]{1,120}?\)(?=/)")
_AFTER = pattern(r"\$\{?PATH\b.*|\$\{?PYTHONPATH\b.*")
_OPT = pattern(r"/opt/(?!ros\b)[\w+.-]+(?:/[\w+.$-]+)+")
_OF_OTHERS = pattern(r"(?:ROS|RMW|AMENT|COLCON|CATKIN|CUDA|CMAKE|CONDA|PIP)_\w+|\w*PATH|HOME|PWD")


def read(repository: Repository, file: File, text: str) -> Iterator[Mention]:
    """Yield ``NAME=./FOLDER`` for places of the tree, ``PATH=/opt/NAME/bin`` for such folders of packages."""
    if "export " not in text or file.path.count("/") > DEEPEST:
        return
    known: dict[str, str] = {}
    text = _PYTHON.sub(f"python{PYTHON}", text.replace("`pwd`", "$(pwd)"))
    for match in _EXPORT.finditer(text):
        name, value = match[1], _with(match[2], known)
        found = _in_opt(value) if name in {"PATH", "PYTHONPATH"} else ""
        if not found and not _OF_OTHERS.fullmatch(name):
            found = place_of(value, repository, cloned="git clone" in text[: match.start()])
            known |= {name: found} if found else {}
        told: list[tuple[Literal["variable", "python_path"], str]] = []
        told += [("variable", f"{name}={found}")] if found else []
        if name == "PYTHONPATH" and not found:
            told += [("python_path", posixpath.normpath(part)) for part in _placed(match[2], known)]
        for topic, said in told:
            at = text.count("\n", 0, match.start(1)) + 1
            yield Mention(topic=topic, value=said, source="readme", file=file.path, line=at, text=match[0].strip()[:80])


def _placed(value: str, known: Mapping[str, str]) -> Iterator[str]:
    """Yield the folders of a path that are the places of variables: ``${A_ROOT}:${B_ROOT}/python``."""
    for part in re.sub(r"[\"']", "", value).split(":"):
        placed = _with(part, known)
        if placed != part and placed.startswith("./") and not placed.endswith(".py"):
            yield placed


def place_of(value: str, repository: Repository, *, cloned: bool) -> str:
    """Return a file or folder of the tree as ``./PATH``, ``""`` for what is none.

    It has to be named below where the page is, below the repository's name, or below a blank that stands for it. What
    lies in a submodule may not be there yet. ``cloned``: the page clones the repository, whose name is its folder then.
    """
    path = _BLANK.sub(lambda blank: _named(blank, repository), value.strip("\"'"))
    parts = path.split("/")
    if re.search(r"[\s:*]", path) or len(parts) < 2:
        return ""
    if cloned and len(parts) == 2 and HERE.match(parts[0]) and bare_name(parts[1]) == bare_name(repository.name):
        return "./"
    ours = [at for at, part in enumerate(parts[:-1]) if bare_name(part) == bare_name(repository.name)]
    start = ours[-1] if ours else 0 if HERE.match(parts[0]) else None
    inside = "/".join(part for part in parts[start + 1 :] if part not in {"", "."}) if start is not None else ""
    if not inside or "$" in inside or ".." in inside.split("/"):
        return ""
    there = repository.has(inside) or inside in repository.folders
    return f"./{inside}" if there or f"{inside}/".startswith(_submodules(repository)) else ""


def _submodules(repository: Repository) -> tuple[str, ...]:
    return tuple(f"{path}/" for path in submodules(repository))


def _named(blank: re.Match[str], repository: Repository) -> str:
    return repository.name if _REPOSITORY.search(blank[0]) else "blank"


def _with(value: str, known: Mapping[str, str]) -> str:
    return _USED.sub(lambda used: known.get(used[1] or used[2], used[0]), value)


def _in_opt(value: str) -> str:
    """Return the folders in ``/opt`` that a path begins with, if it has no others."""
    first = _AFTER.sub("", value.strip("\"'")).rstrip(":\"'{")
    parts = first.split(":")
    return first if all(map(_OPT.fullmatch, parts)) else ""
