"""What a Dockerfile takes from elsewhere than its build context, and what its last stage holds."""

from __future__ import annotations

import posixpath
import re
import sys
from collections.abc import Mapping, Sequence
from typing import Protocol

from roslab.evidence.lex.dockerfile import Instruction
from roslab.evidence.lex.shell import expand
from roslab.values.pattern import pattern

_NAMED = pattern(r"\bAS[ \t]+(\S+)[ \t]*$", 2)
_MOUNTED = pattern(r"--mount=(?:\S*,)?from=([^,\s]+)")
_COPIED = pattern(r"--from=[\"']?([^\s\"']+)")
_WHOLE = pattern(r"--from=\S+[ \t]+(?:--\S+[ \t]+)*/\.?[ \t]+/")
_ROOT = pattern(r"(?:^|[ \t])\S+\.(?:tar(?:\.\w+)?|tgz|txz)[ \t]+/[ \t]*$")
"""The tree of a system, which ADD unpacks."""


def taken(written: Sequence[Instruction], known: Mapping[str, str]) -> tuple[tuple[str, int], ...]:
    """Return the images and named contexts that files are copied or mounted from, each with its line; no stages.

    https://docs.docker.com/reference/dockerfile/#copy---from, read 2026-11-26. ``known``: the values of variables.
    """
    stages = {match[1].lower() for each in written if each.name == "FROM" and (match := _NAMED.search(each.text))}
    found: list[tuple[str, int]] = []
    for each in written:
        here = _MOUNTED.findall(each.text) if each.name == "RUN" else []
        here += _COPIED.findall(each.text) if each.name == "COPY" else []
        names = (expand(name, known) for name in here)
        found += [(name, each.line) for name in names if not (name.lower() in stages or name.isdigit() or "$" in name)]
    return tuple(found)


def entered(written: Sequence[Instruction], folders: Sequence[str]) -> tuple[tuple[str, int], ...]:
    """Return those of some folders of the tree whose whole paths a step names, each with the line of the first."""
    runs = [each for each in written if each.name == "RUN"]
    found = (
        (
            name,
            next((each.line for each in runs if re.search(rf"(?<![\w.-]){re.escape(name)}(?![\w.-])", each.text)), 0),
        )
        for name in folders
    )
    return tuple((name, line) for name, line in found if line)


def copied_from(written: Sequence[Instruction]) -> str | None:
    """Return the stage whose files the last one copies, as it is written, ``None`` where it copies of none."""
    return next((match[1] for each in reversed(_last(written)) if (match := _COPIED.search(each.text))), None)


def unused(written: Sequence[Instruction], known: Mapping[str, str]) -> tuple[range, ...]:
    """Return the lines of each stage that the image does not come from.

    It comes from the last stage, from what that starts from, and from what these copy or mount from.
    ``known``: the values of variables.
    """
    stages: list[tuple[str, str, list[Instruction]]] = []
    for each in written:
        if each.name == "FROM":
            text = expand(each.text.strip(), known)
            base = next((word for word in text.split() if not word.startswith("--")), "").lower()
            stages.append((match[1].lower() if (match := _NAMED.search(text)) else "", base, []))
        if stages:
            stages[-1][2].append(each)
    left, found = [len(stages) - 1] if stages else [], set[int]()
    while left:
        index = left.pop()
        if index in found:
            continue
        found.add(index)
        _, base, inside = stages[index]
        taken_from = [name for each in inside for name in (*_COPIED.findall(each.text), *_MOUNTED.findall(each.text))]
        for name in (base, *(expand(name, known).lower() for name in taken_from)):
            before = [at for at, (other, _, _) in enumerate(stages[:index]) if other and other == name]
            left += before[-1:] or ([int(name)] if name.isdigit() and int(name) < index else [])
    begins = [inside[0].line for _, _, inside in stages]
    return tuple(range(begins[at], [*begins, sys.maxsize][at + 1]) for at in range(len(stages)) if at not in found)


def only_files(written: Sequence[Instruction], base: str | None) -> str | None:
    """Return why an image of the last stage runs nothing: it starts from nothing and has no system, and no program.

    ``base``: what that stage starts from.
    """
    last = _last(written)
    if base != "scratch" or any(each.name in {"CMD", "ENTRYPOINT"} for each in last):
        return None
    if any(_WHOLE.search(each.text) or (each.name == "ADD" and _ROOT.search(each.text)) for each in last):
        return None
    line = next((each.line for each in reversed(written) if each.name == "FROM"), 1)
    return f"its last stage, line {line}, starts from scratch and holds some files and no system that runs a command"


class _Stage(Protocol):
    source: str | None
    kept: tuple[str, ...] | None


def kept(body: str, into: _Stage, stages: Mapping[str, _Stage]) -> tuple[str, ...] | None:
    """Return what a stage has of the tree after it copied from another one, by the paths from the root.

    ``body``: that COPY; ``None`` where it may be anything, as the place of the tree in the other stage is not known.
    """
    named = _COPIED.search(body)
    stage = stages.get(named[1].lower()) if named else None
    if into.kept is None or named is None or named[1].isdigit():
        return None
    if stage is None or (stage.source is None and stage.kept == ()):
        return into.kept  # another image, or a stage without any of the tree
    words = [word for word in body.split() if not word.startswith("--")]
    if stage.source is None or "$" in stage.source or any(mark in body for mark in '$*["'):
        return None
    found: list[str] = []
    tree = posixpath.normpath(stage.source)
    for word in words[:-1]:
        path = posixpath.normpath(posixpath.join("/", word))
        if f"{tree}/".startswith(f"{path.rstrip('/')}/"):
            return None
        found += [posixpath.relpath(path, tree)] if path.startswith(f"{tree}/") else []
    return (*into.kept, *found)


def _last(written: Sequence[Instruction]) -> list[Instruction]:
    begins = max((index for index, each in enumerate(written) if each.name == "FROM"), default=0)
    return [*written[begins:]]
