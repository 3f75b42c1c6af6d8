"""Pages of copied packages that a distribution released: they tell how to start the package, and not the repository."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.decide.candidate import Candidate
from roslab.decide.ros.source_names import address, akin
from roslab.decide.ros.workspace import Packages, packages_of
from roslab.decide.system.by_everybody import PAGES
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.copies import below
from roslab.knowledge.released import ever_released
from roslab.values.pattern import pattern

_WIKI = pattern(r"^https?://(?:(?:www\.)?ros\.org/wiki|wiki\.ros\.org)/\w")
"""The address of a page there: ``http://wiki.ros.org/joy``, and as it was before, ``http://www.ros.org/wiki/joy``."""


def without_copied_packages(candidates: Sequence[Candidate], evidence: Evidence) -> list[Candidate]:
    """Return the commands without those of such pages, and without the launch files beside them where others are left.

    A package of a released name that has no page may be the author's own (``robot``), unless its manifest says that it
    has one in ROS's wiki.
    """
    folders = _copied(evidence, packages_of(evidence))
    pages = [c for c in candidates if c.file.endswith(PAGES) and below(c.file, folders)]
    known = {m.file.rpartition("/")[0] for m in evidence.manifests if _WIKI.search(m.website or "")}
    told = tuple(folder for folder in folders if folder in known or any(below(c.file, (folder,)) for c in pages))
    kept = [c for c in candidates if c not in pages]
    return [c for c in kept if not below(c.file, told)] or kept


def _copied(evidence: Evidence, packages: Packages) -> tuple[str, ...]:
    """Return the folders of packages that a distribution released under the same name, beside packages of its own.

    None of its own is called like it, nor the repository: those that it published itself belong together.
    """
    named = [(m.name, m.file.rpartition("/")[0]) for m in packages.built if m.name]
    own = [name for name, _ in named if not ever_released(name)]
    here = address(evidence.origin).rpartition("/")[2] if evidence.origin else ""
    others = [*own, here] if here else own
    return tuple(
        folder
        for name, folder in named
        if own and folder and ever_released(name) and not any(_alike(name, other) for other in others)
    )


def _alike(name: str, other: str) -> bool:
    return akin(name, other) or akin(other, name) or name == other
