"""What a page fetches beside a library that it builds, and names in an option of that: more modules for it."""

from __future__ import annotations

import shlex

from roslab.config.model import Source
from roslab.decide.ros.source_names import address, fixed, folders
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

ABOVE = "../.."
"""From the folder that a library is built in, ``build`` in its own, to the folder that holds its own."""


def with_beside(source: Source, git: GitSource, evidence: Evidence) -> Source:
    """Return the library ``git`` with what its options name by a folder that the same page fetches at a ref."""
    clones = (*evidence.sources, *(clone for each in evidence.dockerfiles for clone in each.clones))
    others = [c for c in clones if c.file == git.file and c.kind == "clone" and address(c.url) != address(git.url)]
    words = source.cmake_options.split()
    steps: list[str] = [source.prepare] if source.prepare else []
    for index, word in enumerate(words):
        for other in others:
            ref = fixed(other.ref)
            option, _, path = word.partition("=")
            below = _below(path, folders(other))
            if ref and below is not None:
                folder = shlex.quote(f"../{other.name}")
                words[index] = f"{option}={ABOVE}/{other.name}{below}"
                steps.append(f"git clone {shlex.quote(other.url)} {folder}")
                steps.append(f"git -C {folder} -c advice.detachedHead=false checkout {shlex.quote(ref)}")
                break
    return replace(source, cmake_options=" ".join(words), prepare=" && ".join(dict.fromkeys(steps)))


def lies_beside(git: GitSource, evidence: Evidence) -> bool:
    """Tell whether a clone has more modules for a library that the same file compiles: no package of a workspace."""
    libraries = (each for each in evidence.sources if each.installed and each.file == git.file)
    options = (word for each in libraries if address(each.url) != address(git.url) for word in each.options.split())
    return not git.installed and any(_below(word.partition("=")[2], folders(git)) is not None for word in options)


def _below(path: str, names: set[str]) -> str | None:
    """Return what stands in a path behind the folder of one of the names, ``None`` where it names none."""
    parts = path.split("/")
    at = next((index for index, part in enumerate(parts) if index and part in names), None)
    return None if at is None else "".join(f"/{part}" for part in parts[at + 1 :])
