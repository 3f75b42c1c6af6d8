"""What may bring a module that the code imports, by its name: what is installed, what the tree has, and their parts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from functools import lru_cache

from roslab.decide.python.guesses import known_names, known_requirements
from roslab.decide.python.packages import Chosen
from roslab.evidence.facts import Evidence
from roslab.knowledge.never_by_name import widespread_stems
from roslab.values.name import bare_name, canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_OWNED = pattern(r"//[\w.@:-]+/([\w.-]+)/([\w.-]+?)(?:\.git)?/?(?:[@#].*)?$")
"""The owner and the name of a repository in an address."""
_HUMP = pattern(r"(?<=[a-z0-9])(?=[A-Z])")
SHORTEST = 4
"""Fewest letters of a beginning that two names have in common by more than chance."""


def parts_of(names: set[str]) -> set[str]:
    """Return the names with their parts, and without what parts them."""
    return {part for name in names for part in (*name.split("-"), name, bare_name(name))}


def names_there(evidence: Evidence, chosen: Chosen) -> set[str]:
    """Return the names of what is installed, of what the tree has, and their parts."""
    found = known_names(evidence, chosen.files, chosen.projects, chosen.conda) | {
        asked.key for asked in (*chosen.declared, *chosen.guessed, *extras_of(evidence))
    }
    found |= {canonicalize_name(git.name.rpartition("/")[2]) for git in evidence.sources if git.kind != "link"}
    folders = (asked.url.partition("#subdirectory=")[2] for asked in chosen.guessed)
    found |= {canonicalize_name(part) for folder in folders for part in folder.split("/") if part}
    return found | parts_of(found - _own(evidence, chosen)) | {name.replace("-", "") for name in found}


def of_owners(chosen: Chosen) -> set[str]:
    """Return the repositories that pip installs, each with its owner: ``tensorflow_docs`` is of ``tensorflow/docs``."""
    addresses = (_OWNED.search(asked.url) for asked in (*chosen.declared, *chosen.guessed) if asked.vcs)
    return {canonicalize_name(f"{address[1]}-{address[2]}") for address in addresses if address}


def _own(evidence: Evidence, chosen: Chosen) -> set[str]:
    """Return the names of the tree's own projects that nothing else has: each is called after what it needs.

    The tree's own modules are no imports of others. Not of one that compiles: its modules may have any name.
    """
    own = {canonicalize_name(each.name) for each in evidence.python if each.name and not each.extensions}
    asked = {each.key for each in (*chosen.declared, *chosen.guessed, *extras_of(evidence))}
    return (
        own - asked - {each.key for each in known_requirements(evidence, chosen.files, chosen.projects, chosen.conda)}
    )


def declares(chosen: Chosen) -> bool:
    """Tell whether anything names packages: a file, an environment, or a project."""
    declared = bool(chosen.files or chosen.conda or chosen.declared)
    return declared or any(project.requirements for project in chosen.projects)


def absent(evidence: Evidence) -> bool:
    """Tell whether a submodule is not checked out: its folders have names that nobody knows."""
    return any(git.kind == "submodule" and git.absent for git in evidence.sources)


def extras_of(evidence: Evidence) -> Iterator[Requirement]:
    """Yield what the projects ask for in extras: who needs such a module knows where it comes from."""
    for project in evidence.python:
        yield from (asked for asked in project.requirements if asked.role == "extra")


def begins_like(module: str, stems: Set[str]) -> bool:
    """Tell whether a module has the beginning of a package's name, or that of it."""
    name = bare_name(module)
    whole, begun = _begun(frozenset(stems))
    return name in begun or any(name[:end] in whole for end in range(SHORTEST, len(name)))


def excuses(stems: Set[str], module: str) -> bool:
    """Tell whether one of the names may be of the package that brings a module: it is that name, or has a part more.

    What begins like a name without being parted from it is another one: ``torchsummary`` is none of ``torch``. So is
    what has only a beginning in common that packages of many authors share: ``torch_geometric``. A capital parts too.
    """
    name = canonicalize_name(_HUMP.sub("-", module))
    whole, begun = _parted(frozenset(stems))
    return name in begun or any(part in whole for part in _beginnings(name) if part not in widespread_stems())


@lru_cache(maxsize=4)
def _begun(stems: frozenset[str]) -> tuple[frozenset[str], frozenset[str]]:
    """Return the names that are long enough, and all that these begin with: a tree may import thousands of modules."""
    whole = frozenset(stem for stem in stems if len(stem) >= SHORTEST)
    return whole, frozenset(stem[:end] for stem in whole for end in range(len(stem) + 1))


@lru_cache(maxsize=4)
def _parted(stems: frozenset[str]) -> tuple[frozenset[str], frozenset[str]]:
    """Return the names that are long enough as an index has them, and what these begin with, parted from the rest."""
    whole = frozenset(canonicalize_name(stem) for stem in stems if len(stem) >= SHORTEST)
    return whole, whole | {part for stem in whole for part in _beginnings(stem)}


def _beginnings(name: str) -> Iterable[str]:
    """Yield what a name begins with, parted from the rest: ``a`` and ``a-b`` of ``a-b-c``."""
    return (name[:at] for at, letter in enumerate(name) if letter == "-")
