"""What belongs in the tree and is not checked out: submodules, and repositories that a page clones there."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Config, Source
from roslab.decide.decision import Reason, Warning_
from roslab.decide.reasons import because, warn
from roslab.decide.ros.source_names import address, fixed
from roslab.decide.ros.weights import Weight
from roslab.decide.ros.workspace import Packages, packages_of
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.copies import below
from roslab.evidence.ros.clonable import ADDRESS, PATH, can_be_cloned
from roslab.evidence.ros.vcs import https
from roslab.values.dataclass import replace
from roslab.values.origin import Place

FEW = 4
"""Of so many packages one is its own, at most, where those that start nothing count for nothing."""


def in_tree(evidence: Evidence, config: Config, before: str) -> tuple[list[tuple[GitSource, Source]], list[Reason]]:
    """Return what the image clones there, each under its path, and a reason for each of these and other submodules.

    A page may clone by ssh what a gitlink records: the image has no key, and clones it by https as everything else.
    ``before``: the day of which it is taken where no commit is known.
    """
    empty: list[tuple[GitSource, Source]] = []
    reasons: list[Reason] = []
    for git in map(_by_https, evidence.sources):
        clone = can_be_cloned(git) and not config.compatible
        if git.kind == "inside" and clone:
            taken = git if git.ref else _of_ci(git, evidence)
            empty.append((taken, _source(taken, before or evidence.pip_day or "")))
            why = "the page clones it, and the code takes a folder of it from there"
            why += f"; CI takes {taken.ref} of it" if taken.ref != git.ref else ""
            reasons.append(because("source", git.name, why, taken, weight=Weight.LISTED))
        elif git.kind == "submodule":
            why = f"a submodule ({git.url}): check it out with the repository"
            if git.absent and clone:
                commit = f"at {git.ref}" if git.ref else "at no fixed commit, for git does not tell it"
                why = f"a submodule that is not checked out: it is cloned from {git.url} {commit}"
                why += "; ROS lists that under its name, and it is left out where that has no such commit" * git.by_name
                empty.append((git, _source(git, before)))
            reasons.append(because("source", git.name, why, git, weight=Weight.SUBMODULE, decisive=False))
    return empty, reasons


def not_cloned(evidence: Evidence, config: Config) -> Iterator[Warning_]:
    """Yield a warning for each folder of another repository that stays empty in the image, for its address or path.

    A configuration of before clones none at all, as it always did.
    """
    for git in map(_by_https, evidence.sources):
        left = git.kind == "inside" or (git.kind == "submodule" and git.absent)
        if left and not config.compatible and not can_be_cloned(git):
            why = "no address that an image can clone from" if not ADDRESS.match(git.url) else "no path that is taken"
            told = git.name if ADDRESS.match(git.url) else git.url
            message = f"{git.name} is empty in the image, and what needs it stops: {told} is {why}"
            yield warn(f"{message}; check it out before the build, or give its address under `source`", git)


def _by_https(git: GitSource) -> GitSource:
    url = https(git.url)
    return git if url == git.url else replace(git, url=url)


def inside_packages(evidence: Evidence) -> frozenset[str]:
    """Return the paths of the submodules that lie in folders of packages which are built."""
    folders = [manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built]
    inside = tuple(f"{folder}/" if folder else "" for folder in folders)
    return frozenset(git.name for git in evidence.sources if git.kind == "submodule" and git.name.startswith(inside))


def _of_ci(git: GitSource, evidence: Evidence) -> GitSource:
    """Return what a page clones at the commit that CI takes of the same repository, if CI takes one."""
    from roslab.evidence.prose.checkouts import COMMIT  # noqa: PLC0415 - few pages clone

    for other in evidence.sources:
        same = other.kind == "clone" and other.file.startswith(".") and address(other.url) == address(git.url)
        if same and COMMIT.fullmatch(other.ref or ""):
            return replace(git, ref=other.ref, file=other.file, line=other.line)
    return git


def apart(evidence: Evidence, packages: Packages) -> tuple[str, ...]:
    """Return the folders of others' repositories, where the repository has packages of its own beside them.

    They are submodules, checked out or not, and copies. A workspace may need a part of their packages.
    """
    modules = [git.name for git in evidence.sources if git.kind == "submodule"]
    copied = [folder for folder in evidence.repositories if not below(f"{folder}/", modules)]
    folders = tuple(folder for folder in (*modules, *copied) if PATH.fullmatch(folder))
    inside = tuple(f"{folder}/" for folder in folders)
    return folders if any(not manifest.file.startswith(inside) for manifest in packages.built) else ()


def copied(evidence: Evidence, packages: Packages) -> tuple[str, ...]:
    """Return the folders with copies of others' repositories, if there are packages of its own beside them.

    A few that start nothing, as the messages beside the copies of a whole workspace, are no other thing to start.
    """
    whole = evidence.repositories
    folders = [m.file.rpartition("/")[0] for m in packages.built if not below(m.file, whole)] if whole else []
    if FEW * len(folders) >= len(packages.built):
        return whole if folders else ()
    own = tuple(f"{folder}/" for folder in folders)
    files = [launch.file for launch in evidence.launch] + [program.file for program in evidence.programs]
    files += [project.file for project in evidence.cmake if own and project.executables]
    return whole if any(file.startswith(own) and not below(file, whole) for file in files) else ()


def _source(git: GitSource, before: str) -> Source:
    place = Place(file=git.file, line=git.line)
    ref = fixed(git.ref)
    return Source(
        name=git.name,
        repo=git.url,
        ref=ref,
        before="" if git.ref else before,
        build="none",
        unasked=git.by_name,
        place=place,
    )
