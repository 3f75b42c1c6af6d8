"""Packages of the tree that an author's Dockerfile does not copy although one that it builds requires them."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.ros.source_names import asked_for, plain
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.released import released


def uncopied_package(authored: AuthorDockerfile, evidence: Evidence, ros_distro: str | None) -> str | None:
    """Return why a Dockerfile cannot build what it copies: the first such package with the line that requires it.

    ``None`` where it copies everything, builds no workspace, or where a clone or apt may bring the package.
    """
    held = authored.copied
    builds = any(each.topic == "build_tool" and each.file == authored.file for each in evidence.mentions)
    if not held or "" in held or not builds:
        return None
    folders: dict[str, list[str]] = {}
    for manifest in evidence.manifests:
        if manifest.name and not manifest.ignored:
            folders.setdefault(manifest.name, []).append(manifest.file.rpartition("/")[0])
    packages = {folder for found in folders.values() for folder in found}
    known = released(ros_distro or "")
    for project in evidence.cmake:
        folder = project.file.rpartition("/")[0]
        if folder not in packages or not _inside(folder, held):
            continue
        for asked in project.dependencies:
            lacking = folders.get(asked.name, ()) if _required(asked) else ()
            there = any(_partly(each, held) for each in lacking) or asked.name in known
            if lacking and not there and not _brought(asked, authored):
                return f"it copies {folder} and not {lacking[0]}, which {asked.file}:{asked.line} requires"
    return None


def copied_names(names: tuple[str, ...], dockerfile: str | None, evidence: Evidence) -> tuple[str, ...]:
    """Return the names of the packages that an author's Dockerfile copies: all of them where it copies none by name.

    It then has them otherwise; ``dockerfile``: the one that is built, if any.
    """
    held = next((each.copied for each in evidence.dockerfiles if each.file == dockerfile), ())
    if not held or "" in held:
        return names
    there = {m.name for m in evidence.manifests if _partly(m.file.rpartition("/")[0], held)}
    return tuple(name for name in names if name in there) or names


def _required(asked: Dependency) -> bool:
    return asked.namespace in {"ros", "cmake"} and asked.strength == "declared" and asked.role == "build"


def _inside(folder: str, held: Iterable[str]) -> bool:
    """Tell whether a folder is copied as a whole."""
    return any(folder == source or folder.startswith(f"{source}/") for source in held)


def _partly(folder: str, held: Iterable[str]) -> bool:
    """Tell whether anything of a folder is copied."""
    return not folder or any(folder == s or folder.startswith(f"{s}/") or s.startswith(f"{folder}/") for s in held)


def _brought(asked: Dependency, authored: AuthorDockerfile) -> bool:
    """Tell whether the Dockerfile installs a package of that name with apt, or clones what may hold it."""
    name = plain(asked.name)
    packaged = any(plain(each.name).endswith(f"_{name}") for each in authored.dependencies)
    return packaged or any(asked_for(git, {name: asked}, frozenset()) for git in authored.clones)
