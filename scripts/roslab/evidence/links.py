"""Repositories that the commit records in the tree without an address, and that a page clones.

``git add`` of a folder that is a clone records its commit alone, and leaves it empty for everybody else:
https://git-scm.com/docs/gitsubmodules, 2026-11-26
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace


def read(repository: Repository, sources: Iterable[GitSource]) -> Iterator[GitSource]:
    """Yield each such folder as a submodule: that which a page clones by its name, at the commit that is recorded.

    Of several folders of one name the first is meant. What is checked out is read as a part of the tree.
    """
    sources = tuple(sources)
    known = {git.name for git in sources if git.kind in {"submodule", "inside"}}
    clones: dict[str, GitSource] = {}
    for git in sources:
        if git.kind == "clone" and not places.vendored(git.file):
            clones.setdefault(git.folder, git)
    paths = repository.links() if clones else ()
    found: dict[str, str] = {}
    for path in sorted(paths, key=lambda path: path.count("/")):
        name = path.rpartition("/")[2]
        if name in clones and path not in known and path not in repository.folders:
            found.setdefault(name, path)
    commits = repository.recorded(tuple(found.values()))
    for name, path in found.items():
        ref = commits.get(path, clones[name].ref)
        yield replace(clones[name], name=path, into="", ref=ref, strength="declared", kind="submodule", absent=True)
