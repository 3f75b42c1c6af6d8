"""Pythons that pages install by apt: they say which version is meant, and the image brings that by its own means."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.evidence.dependency import Dependency
from roslab.values.pattern import pattern

_PYTHON = pattern(r"python[23]\.\d{1,2}(?:-(?:dev|venv|distutils|full|minimal|lib2to3|tk|gdbm))?")
_ADDS = pattern(r"\bppa:\S+|\badd-apt-repository\b")
_PPA = pattern(r"ppa:deadsnakes/\w+")
"""The PPA of Pythons for Ubuntu: https://launchpad.net/~deadsnakes, 2026-11-27."""
_KINDS = frozenset({"python", "cuda"})


def may_bring(source: str, package: str) -> bool:
    """Tell whether a source of packages may have one: that of Pythons has nothing else."""
    return not _PPA.fullmatch(source) or bool(_PYTHON.fullmatch(package))


def only_python(step: str, kind: Kind) -> bool:
    """Tell whether a step adds the source of Pythons alone, where the image has the Python that is meant."""
    others = [word for word in _ADDS.findall(step) if word.startswith("ppa:") and not _PPA.fullmatch(word)]
    return kind in _KINDS and bool(_PPA.search(step)) and not others


def without_pythons(asked: Iterator[Dependency], kind: Kind) -> Iterator[Dependency]:
    """Leave out the Pythons of one version."""
    for each in asked:
        if not (kind in _KINDS and each.namespace == "apt" and _PYTHON.fullmatch(each.name)):
            yield each
