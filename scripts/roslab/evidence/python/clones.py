"""Repositories that a page clones into the tree, where the code then puts a folder of theirs on its path."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.evidence.dependency import GitSource
from roslab.evidence.python.modules import Module, modules
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

DEEPEST = 1
"""A page below is about a part."""
_ADDED = pattern(r"\bsys\.path\.(?:append|insert|extend)\(([^\n]{1,300})")
_ABSOLUTE = pattern(r"\s*(?:\d+,\s*)?[rfu]?[\"'][/~]")
_TEXT = pattern(r"[\"']([^\"'\n]{1,120})[\"']")


def read(repository: Repository, sources: Iterable[GitSource]) -> Iterator[GitSource]:
    """Yield each such clone with the path in the tree that the code means, once; the first module that names it counts.

    What the tree has a folder of the same name for is there, and what is pip's to install is none of them, nor is the
    repository itself.
    """
    clones = [git for git in sources if git.kind == "clone" and git.file.count("/") <= DEEPEST and not git.installed]
    clones = [git for git in clones if not git.itself and git.name.lower() != repository.name.lower()]
    there = {folder.rpartition("/")[2] for folder in repository.folders}
    found: dict[str, GitSource] = {}
    for git in clones:
        if git.folder not in there and git.folder not in found:
            place = next((path for module in modules(repository) for path in _places(git.folder, module)), None)
            if place:
                found[git.folder] = replace(git, name=place, kind="inside")
    yield from found.values()


def _places(name: str, module: Module) -> Iterator[str]:
    """Yield the paths of a clone of that name that a module puts on its path: ``sys.path.append("../net/src")``.

    One that goes up is taken from the module's folder, another from the root; none leads out of the tree, as that of
    its author's computer does.
    """
    if name not in module.text or "sys.path" not in module.text:
        return
    for match in _ADDED.finditer(module.text):
        if _ABSOLUTE.match(match[1]):
            continue
        written = "/".join(each.strip("/") for each in _TEXT.findall(match[1]))
        if found := re.match(rf"((?:[\w.-]+/)*?{re.escape(name)})(?:/|$)", written):
            up = found[1].startswith("../") or "__file__" in match[1]
            path = posixpath.normpath(posixpath.join(module.file.folder if up else "", found[1]))
            if not path.startswith("../"):
                yield path
