"""The repositories that a page links to or clones and that a module of no table may be one's package of."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from roslab.decide.python.on_index import with_one_word_more
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.knowledge.never_by_name import never_by_name
from roslab.values.dataclass import dataclass
from roslab.values.name import bare_name, canonicalize_name
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


@dataclass(frozen=True, kw_only=True, slots=True)
class Linked:
    """What pages offer, as pip is asked for it."""

    by_name: Mapping[str, Requirement]
    """By the names of modules that are the repository's own, in more than one spelling."""
    to_install: Mapping[str, Requirement]
    """By the names of repositories that a page has people install: a module's may be a part of that."""

    def of_module(self, used: Dependency, *, ros: bool) -> Requirement | None:
        """Return the repository of a module; of a ROS package's, only one that says that it is for Python."""
        spelled = () if ros else (canonicalize_name(used.name), bare_name(used.name))
        names = (*spelled, _of_python(used.name)) if used.strength == "used" else ()
        found = next((self.by_name[name] for name in names if name in self.by_name), None)
        if found or ros or not names or never_by_name(used.name):
            return found
        return next((self.to_install[name] for name in self.to_install if with_one_word_more(used.name, name)), None)


def linked_repositories(evidence: Evidence) -> Linked:
    """Return the repositories that a page at the root links to or clones: a module of no table may be one's package.

    What it clones may have another spelling; of what says in its name that it is for Python, that may be shorter.
    One that has the name of a CMake project of the tree is the repository itself, which compiles that module; one that
    has a submodule's lies in the tree. What a page links to where it tells how to install may have one word more than
    the module: ``acme-api`` of ``acme``.
    """
    found: dict[str, Requirement] = {}
    told: dict[str, Requirement] = {}
    for git in _offered(evidence):
        ref = f"@{git.ref}" if git.ref and re.fullmatch(r"[\w.-]+", git.ref) else ""
        asked = stated(f"git+{https(git.url)}{ref}", "import")
        found.setdefault(canonicalize_name(git.name), asked)
        if of_python := _of_python(git.name):
            found.setdefault(of_python, asked)
        if git.kind == "clone":
            found.setdefault(bare_name(git.name), asked)
        elif (git.told or git.holds or git.to_install) and not git.private:
            told.setdefault(git.name, asked)
    return Linked(by_name=found, to_install=told)


def _offered(evidence: Evidence) -> Iterable[GitSource]:
    inside = {bare_name(project.name) for project in evidence.cmake if project.name}
    inside |= {bare_name(git.name.rpartition("/")[2]) for git in evidence.sources if git.kind == "submodule"}
    for git in evidence.sources:
        offered = git.kind in {"link", "clone"} and "/" not in git.file and not git.installed
        if offered and bare_name(git.name) not in inside:
            yield git


def _of_python(name: str) -> str:
    """Return a name that says that it is for Python as modules do: ``sdk_python`` as ``sdkpy``, ``""`` if none."""
    bare = bare_name(name)
    short = f"{bare.removesuffix('python')}py" if bare.endswith("python") else bare
    return f"{short} of Python" if short.endswith("py") and len(short) > len("py") else ""
