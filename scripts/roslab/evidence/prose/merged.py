"""What texts tell, and the facts of several texts as one."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Mention
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement


@dataclass(frozen=True, slots=True)
class Prose:
    """What texts for people or for other machines tell: READMEs, CI files, install scripts, Dockerfiles."""

    dependencies: tuple[Dependency, ...] = ()
    requirements: tuple[Requirement, ...] = ()
    sources: tuple[GitSource, ...] = ()
    mentions: tuple[Mention, ...] = ()


def merge(parts: Iterable[Prose]) -> Prose:
    """Merge the facts of several texts."""
    parts = tuple(parts)
    return Prose(
        tuple(d for part in parts for d in part.dependencies),
        tuple(r for part in parts for r in part.requirements),
        tuple(s for part in parts for s in part.sources),
        tuple(m for part in parts for m in part.mentions),
    )
