"""Packages that the author's own build leaves out, as its page, its pixi tasks, its CI or its Dockerfile say."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.model import BuildTool
from roslab.decide.ros.marked_clones import by_author
from roslab.decide.ros.workspace import Packages
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import dataclass
from roslab.values.origin import Place

_SKIP = frozenset({"--packages-skip", "--packages-ignore"})
_PART = frozenset({"--packages-select", "--packages-up-to"})
"""https://colcon.readthedocs.io/en/released/reference/package-selection-arguments.html"""
_BY = {
    "ci": "CI takes it out of the workspace",
    "readme": "the page takes it out",
    "dockerfile": "the author's Dockerfile takes it out",
}
_SOURCES = frozenset({"", ".", "..", "src", "~", "…"})
"""What may stand before a path in the tree: the ``src`` of a workspace, or a folder that is not known."""


@dataclass(frozen=True, slots=True)
class Skipped:
    """Where the author's build leaves a package out, and who says so."""

    place: Place
    why: str


def skipped(
    evidence: Evidence, packages: Packages, build_tool: BuildTool, started: Collection[str]
) -> dict[str, Skipped]:
    """Return the packages of the tree that a page at the root, a task of pixi's, a Dockerfile or all of CI leave out.

    Not those that the default command, whose words are ``started``, or what else is built needs.
    """
    found: dict[str, Skipped] = {}
    if build_tool == "colcon":
        for text, place in _builds(evidence):
            for name in _named(text):
                found.setdefault(name, Skipped(place, "the author's build skips it"))
        for name, place in _by_ci(evidence).items():
            found.setdefault(name, Skipped(place, "CI's build skips it"))
    for mention in by_author(evidence):
        place = Place(file=mention.file, line=mention.line)
        for name in _below(mention.value, evidence, packages):
            found.setdefault(name, Skipped(place, f"{_BY[mention.source]} before it builds"))
    found = {name: said for name, said in found.items() if name in packages.names}
    needed = _needed(packages, found.keys(), {*started})
    return {name: said for name, said in found.items() if name not in needed}


def _named(text: str) -> Iterator[str]:
    """Yield the packages that a call of colcon that builds leaves out."""
    words = text.split()
    for index, word in enumerate(words if "build" in words else ()):
        after = words[index + 1 :] if word in _SKIP else []
        end = next((position for position, each in enumerate(after) if each.startswith("-")), len(after))
        yield from after[:end]


def _builds(evidence: Evidence) -> Iterator[tuple[str, Place]]:
    for mention in evidence.mentions:
        if _by_colcon(mention) and mention.source == "readme" and "/" not in mention.file:
            yield mention.text, Place(file=mention.file, line=mention.line)
    for environment in evidence.conda:
        for name, command, line in environment.tasks:
            if name == "build" and "colcon build" in command and "/" not in environment.file:
                yield command, Place(file=environment.file, line=line)


def _by_ci(evidence: Evidence) -> dict[str, Place]:
    """Return the packages that each build of the whole workspace in CI leaves out."""
    calls = [m for m in evidence.mentions if _by_colcon(m) and m.source == "ci"]
    whole = [(m, set(_named(m.text))) for m in calls if "build" in m.text.split() and _PART.isdisjoint(m.text.split())]
    if not whole:
        return {}
    place = Place(file=whole[0][0].file, line=whole[0][0].line)
    return dict.fromkeys(sorted(set.intersection(*(names for _, names in whole))), place)


def _by_colcon(mention: Mention) -> bool:
    return mention.topic == "build_tool" and mention.value == "colcon"


def _below(path: str, evidence: Evidence, packages: Packages) -> Iterator[str]:
    """Yield the packages in a folder of the tree, whose path may begin outside of it; it may be a package's name."""
    own = evidence.origin.rstrip("/").rpartition("/")[2].removesuffix(".git") if evidence.origin else ""
    parts = path.split("/")
    for manifest in packages.built:
        folders = manifest.file.split("/")[:-1]
        inside = any(
            parts[-end:] == folders[:end] and (parts[:-end] or [""])[-1] in {*_SOURCES, own}
            for end in range(1, min(len(folders), len(parts)) + 1)
        )
        if manifest.name and (inside or parts[-1] == manifest.name):
            yield manifest.name


def _needed(packages: Packages, left: Collection[str], started: Collection[str]) -> set[str]:
    """Return what a started package needs at all, and what others that are built need to be built."""
    by_name = {manifest.name: manifest for manifest in packages.built if manifest.name}
    needed = {*started} & by_name.keys()
    pending = [*needed, *(name for name in by_name if name not in left)]
    for name in pending:
        no = {"test", "doc"} if name in needed else {"test", "doc", "exec", "run"}
        for each in by_name[name].dependencies:
            if each.role not in no and each.name in by_name and each.name not in needed:
                needed.add(each.name)
                pending.append(each.name)
    return needed
