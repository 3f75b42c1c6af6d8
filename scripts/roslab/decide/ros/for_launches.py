"""Sister repositories that only launch files want something of: what else is in them is not compiled."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from roslab.config.model import Source
from roslab.evidence.dependency import Dependency
from roslab.values.dataclass import replace

Wanted = Mapping[str, Sequence[tuple[str, Dependency]]]
"""For each source by its name the packages that the table finds in it, each with what asks for it."""
_BUILDS = ("package.xml", "manifest.xml", "CMakeLists.txt", ".cmake")


def only_for_launches(sources: Iterable[Source], wanted: Wanted) -> tuple[Source, ...]:
    """Return the sources, those that launch files alone ask for with the packages that they start or find."""
    return tuple(replace(each, only=_only(wanted.get(each.name, ()))) for each in sources)


def _only(asking: Sequence[tuple[str, Dependency]]) -> tuple[str, ...]:
    started = all(asked.namespace == "ros" and not asked.file.endswith(_BUILDS) for _, asked in asking)
    return tuple(dict.fromkeys(package for package, _ in asking)) if started else ()
