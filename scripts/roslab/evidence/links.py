"""Repositories that the commit records in the tree without an address.

``git add`` of a folder that is a clone records its commit alone, and leaves it empty for everybody else:
https://git-scm.com/docs/gitsubmodules, 2026-11-26
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.knowledge.released import ever_released
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace

MOST = 5
"""Most folders that a message names."""


def read(repository: Repository, sources: Iterable[GitSource]) -> Iterator[GitSource]:
    """Yield each that a page clones by its name as a submodule, at the commit that is recorded.

    Of several folders of one name the first is meant. What is checked out is read as a part of the tree.
    """
    sources = tuple(sources)
    known = {git.name for git in sources if git.kind in {"submodule", "inside"}}
    clones: dict[str, GitSource] = {}
    for git in sources:
        if git.kind == "clone" and not places.vendored(git.file):
            clones.setdefault(git.folder, git)
    paths = repository.links if clones else ()
    found: dict[str, str] = {}
    for path in sorted(paths, key=lambda path: path.count("/")):
        name = path.rpartition("/")[2]
        if name in clones and path not in known and path not in repository.folders:
            found.setdefault(name, path)
    commits = repository.recorded(tuple(found.values()))
    for name, path in found.items():
        ref = commits.get(path, clones[name].ref)
        yield replace(clones[name], name=path, into="", ref=ref, strength="declared", kind="submodule", absent=True)


def lost(repository: Repository, sources: Iterable[GitSource]) -> dict[str, str]:
    """Return those that nothing tells the address of, each path with its commit: they are empty in every clone."""
    empty = repository.listing.empty
    known = {git.name for git in sources if git.kind in {"submodule", "inside"}}
    recorded = repository.recorded(empty) if empty else {}
    return {path: commit for path, commit in recorded.items() if path not in known}


def listed(paths: Mapping[str, str]) -> tuple[GitSource, ...]:
    """Return the lost ones that are called like a repository which ROS distributions list, each as that repository.

    It is one if it has the commit, which only the build can ask.
    """
    found = []
    for path, commit in paths.items():
        from roslab.knowledge.listed_repositories import listed_repository  # noqa: PLC0415 - few trees have lost links

        name = path.rpartition("/")[2]
        if (url := listed_repository(name)) and not places.aside(path):
            found.append(
                GitSource(
                    name=path,
                    url=url,
                    ref=commit,
                    strength="declared",
                    file=path,
                    line=1,
                    kind="submodule",
                    absent=True,
                    by_name=True,
                )
            )
    return tuple(found)


def problems(paths: Iterable[str], named: Iterable[GitSource]) -> Iterator[tuple[str, str | None, int | None]]:
    """Yield the message about the lost ones, which are in no file; ``named``: those whose repository is tried."""
    tried = {git.name: git.url.removesuffix(".git") for git in named}
    unknown = [path for path in paths if path not in tried]
    why = "the commit records a commit of another repository there, and nothing tells its address"
    what = "add it again with `git submodule add ADDRESS FOLDER`, or name the repository under `source` in roslab.yaml"
    if unknown:
        more = f" and {len(unknown) - MOST} more" if len(unknown) > MOST else ""
        yield f"empty in a clone, for {why}: {', '.join(unknown[:MOST])}{more}; {what}", None, None
    if tried:
        more = f" and {len(tried) - MOST} more" if len(tried) > MOST else ""
        names = ", ".join(f"{path} ({url})" for path, url in [*tried.items()][:MOST])
        where = "the image takes the commit from the repository of that name which ROS lists, if that has it"
        yield f"empty in a clone, for {why}: {names}{more}; {where}; else {what}", None, None


def packages(paths: Iterable[str]) -> Iterator[Dependency]:
    """Yield the packages that a distribution has under the names of lost folders.

    Of names with one word alone (``perception``, ``robot``) many are an author's own, and ROS's are metapackages.
    """
    for path in paths:
        name = path.rpartition("/")[2]
        if "_" in name and ever_released(name) and not places.aside(path):
            yield Dependency(namespace="ros", name=name, strength="used", file=path, line=1, role="exec")
