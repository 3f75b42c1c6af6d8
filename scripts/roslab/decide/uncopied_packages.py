"""Packages of the tree that an author's Dockerfile does not copy although one that it builds requires them."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.ros.source_names import asked_for, plain
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.evidence.launch_file import LaunchFile
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


def only_manifest(authored: AuthorDockerfile, evidence: Evidence) -> str | None:
    """Return why a Dockerfile compiles nothing: it copies a package.xml, and of no package what builds it.

    Such an image has what the packages need; the repository is checked out in it later.
    """
    held = authored.copied
    if not held or "" in held:
        return None
    found = [manifest for manifest in evidence.manifests if manifest.name and not manifest.ignored]
    there = [manifest.file for manifest in found if _inside(manifest.file, held)]
    if not there or any(_built(file.rpartition("/")[0], held) for file in there):
        return None
    return f"it copies {there[0]} and nothing that builds the package: the image is for what the repository needs"


def uncopied_by_command(
    authored: AuthorDockerfile, words: tuple[str, ...], launch: LaunchFile | None, evidence: Evidence
) -> str | None:
    """Return why a container cannot start a command of ROS: the first package of the tree that it needs and has not.

    ``launch``: the launch file of the tree that the command starts, if any.
    """
    held = authored.copied
    if not held or "" in held:
        return None
    folders: dict[str, list[str]] = {}
    for manifest in evidence.manifests:
        if manifest.name and not manifest.ignored:
            folders.setdefault(manifest.name, []).append(manifest.file.rpartition("/")[0])
    asked = [each for each in (*launch.dependencies, *launch.reached) if each.strength != "optional"] if launch else []
    named = {words[0]: "", **{each.name: f" ({each.file}:{each.line})" for each in asked if each.namespace == "ros"}}
    for name, where in named.items():
        lacking = folders.get(name, ())
        if lacking and not any(_built(folder, held) for folder in lacking):
            return f"it does not copy {lacking[0]}, and what would be started in it needs the package {name}{where}"
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


def _built(folder: str, held: Iterable[str]) -> bool:
    """Tell whether what builds a package is copied."""
    return any(_inside(f"{folder}/{name}".strip("/"), held) for name in ("CMakeLists.txt", "setup.py"))


def _partly(folder: str, held: Iterable[str]) -> bool:
    """Tell whether anything of a folder is copied."""
    return not folder or any(folder == s or folder.startswith(f"{s}/") or s.startswith(f"{folder}/") for s in held)


def _brought(asked: Dependency, authored: AuthorDockerfile) -> bool:
    """Tell whether the Dockerfile installs a package of that name with apt, or clones what may hold it."""
    name = plain(asked.name)
    packaged = any(plain(each.name).endswith(f"_{name}") for each in authored.dependencies)
    return packaged or any(asked_for(git, {name: asked}, frozenset()) for git in authored.clones)
