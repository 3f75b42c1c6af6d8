"""Submodules that are checked out: each is a project of its own, and its pages and manifests are about that one."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.facts import RequirementFile
from roslab.evidence.prose.absent_launches import launch_there
from roslab.evidence.prose.merged import Prose
from roslab.evidence.ros import vcs
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement


def without(repository: Repository) -> Repository:
    """Return the repository without the files of its submodules; the same object where it has none."""
    folders = tuple(f"{name}/" for name in vcs.submodules(repository))
    inside = {file.path for file in repository.files if file.path.startswith(folders)} if folders else set()
    return repository.leaving_out(inside) if inside else repository


def with_launches(prose: Prose, whole: Repository) -> Prose:
    """Return what pages tell without launch files that the tree seemed to lack and that its submodules have."""
    kept = (m for m in prose.mentions if m.topic != "unlaunched" or not launch_there(m.value.split()[2], whole))
    return replace(prose, mentions=tuple(kept))


def named(
    files: tuple[RequirementFile, ...], own: Repository, asked: Iterable[Requirement]
) -> tuple[RequirementFile, ...]:
    """Return the requirement files of the repository itself, and those of submodules that a page installs."""
    installed = tuple(f"/{each.written.removeprefix('./')}" for each in asked if each.role == "file")
    return tuple(file for file in files if own.has(file.file) or f"/{file.file}".endswith(installed))
