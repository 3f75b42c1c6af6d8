"""Patches of the tree that are applied to what the image clones."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from roslab.config.model import Patch, Source
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.source_names import akin, plain
from roslab.evidence.facts import Evidence
from roslab.evidence.patch import Patch as Found
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

WEIGHT = 60
_PLAIN = pattern(r"[\w./+~-]+")
"""A path that a mount of a Dockerfile, whose options commas part, can name."""


def with_patches(sources: Choice[Sources], evidence: Evidence) -> Choice[Sources]:
    """Return what is built from source with the patches that the author applies to it, each told among the reasons."""
    answer = sources.answer
    names = [plain(source.name) for source in (*answer.sources, *answer.submodules)]
    given: dict[str, list[Found]] = {}
    for found in evidence.patches:
        name = patched(found, names)
        there = given.setdefault(name, [])
        if name and _PLAIN.fullmatch(found.path) and all(found.path != each.path for each in there):
            there.append(found)
    applied = [(name, found) for name, there in given.items() if name for found in there]
    if not applied:
        return sources
    reasons = tuple(
        because("source", name, f"the author applies {found.path} to it", found, weight=WEIGHT)
        for name, found in applied
    )
    changed = replace(
        answer,
        sources=tuple(_with(source, given) for source in answer.sources),
        submodules=tuple(_with(source, given) for source in answer.submodules),
    )
    return replace(sources, answer=changed, reasons=(*sources.reasons, *reasons))


def patched(found: Found, names: Collection[str]) -> str:
    """Return which of some clones, by their names in one spelling, a patch is for, ``""`` for none of them.

    It is applied in the folder of one or below. Where that is not known, it is for the one whose packages have names
    like the folders of the files that it changes.
    """
    named = [plain(part) for part in found.folder.split("/")]
    if inside := next((part for part in reversed(named) if part in names), ""):
        return inside
    folders = {part for path in found.touches for part in path.split("/")[:-1]}
    alike = {name for name in names if any(akin(name, folder) for folder in folders)}
    return alike.pop() if len(alike) == 1 else ""


def told_by(evidence: Evidence, addresses: Iterable[str]) -> frozenset[tuple[str, int]]:
    """Return the lines, each with its file, that apply a patch to what is cloned from one of the addresses."""
    names = {plain(url.rstrip("/").removesuffix(".git")) for url in addresses}
    return frozenset((found.file, found.line) for found in evidence.patches if patched(found, names))


def _with(source: Source, given: dict[str, list[Found]]) -> Source:
    found = given.get(plain(source.name), [])
    return replace(source, patches=tuple(_patch(each, plain(source.name)) for each in found)) if found else source


def _patch(found: Found, name: str) -> Patch:
    parts = found.folder.split("/")
    start = next((index + 1 for index, part in reversed([*enumerate(parts)]) if plain(part) == name), len(parts))
    return Patch(
        path=found.path,
        below="/".join(parts[start:]),
        command=found.command,
        stops=found.stops,
        place=Place(file=found.file, line=found.line),
    )
