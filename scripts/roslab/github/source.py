"""Completing a checkout before anything is read: submodules, large files, and tags if a version depends on them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from roslab.errors import ConfigurationError, Problem
from roslab.evidence.python import project
from roslab.github import checkout, workflow
from roslab.plan.version import of_projects
from roslab.repository import fetching
from roslab.repository.checkout import Repository, printable
from roslab.values.origin import Input

NAMED = 5
"""Most files that a warning names."""


def complete(top: Path, part: str, environment: Mapping[str, str]) -> None:
    """Fetch what is missing in the folder ``part`` of a checkout, ``""`` for all of it.

    What cannot be fetched gives a warning; the plan decides later whether it is fatal. INPUT_REF is a commit, git tag
    or branch to build instead of the event's. Raises ``ConfigurationError`` if it does not exist.
    """
    access = fetching.Access(
        server=environment.get("GITHUB_SERVER_URL") or "https://github.com",
        token=environment.get("ROSLAB_SOURCE_TOKEN", ""),
        key=environment.get("ROSLAB_SOURCE_KEY", ""),
    )
    asked = environment.get("INPUT_REF", "").strip()
    with fetching.git(access) as git, workflow.group("Fetch submodules, large files and tags"):
        if asked and (why := fetching.checkout(git, top, asked)):
            hint = "write a whole commit, a git tag or a branch of this repository"
            message = f"{printable(asked)} cannot be checked out: {why}"
            raise ConfigurationError(Problem(message=message, hint=hint, origin=Input(name="ref")))
        root = checkout.part(top, part)
        missing = fetching.submodules(git, top, part=part)
        left, why = fetching.large_files(git, root)
        unread = fetching.tags(git, root) if _asks_for_tags(root) else ""
    for submodule in missing:
        hint = "a private one needs the secret source-token or source-key; `submodules: required` stops the run"
        where = f"the submodule {submodule.path} of {submodule.url} is left out: {submodule.reason}"
        workflow.warn(Problem(message=where, hint=hint))
    if left:
        names = ", ".join(left[:NAMED]) + (f" and {len(left) - NAMED} more" if len(left) > NAMED else "")
        reason = f" ({why})" if why else ""
        workflow.warn(
            Problem(
                message=f"large files of git LFS are not there, only their pointers{reason}: {names}",
                hint="check the repository out with `lfs: true`, or fetch them where the program starts",
            )
        )
    if unread:
        workflow.warn(Problem(message=f"the tags, which a version comes from, cannot be fetched: {unread}"))
    workflow.say(f"{len(missing)} submodules missing, {len(left)} large files missing")


def _asks_for_tags(root: Path) -> bool:
    projects = project.read(Repository.open(root))
    return bool(of_projects(projects, [entry.folder for entry in projects]))
