"""Sister repositories of which launch files alone want something, or messages alone: the rest of them is hidden."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

from roslab.config.model import Source
from roslab.decide.ros.source_names import OF_MESSAGES, akin
from roslab.evidence.dependency import Dependency
from roslab.knowledge.ros_sources import packages_at
from roslab.values.dataclass import replace

Wanted = Mapping[str, Sequence[tuple[str, Dependency]]]
"""For each source by its name the packages that the table finds in it, each with what asks for it."""
_BUILDS = ("package.xml", "manifest.xml", "CMakeLists.txt", ".cmake")


def only_for_launches(
    sources: Iterable[Source], wanted: Wanted, asked: Collection[str], *, others: bool
) -> tuple[Source, ...]:
    """Return the sources, those that launch files alone ask for with the packages that they start or find.

    So it is with those that have more than messages, and of which nothing else is asked for, unless a list or a page
    names any of the sources, or there are ``others``: these may need more of them. ``asked``: names that neither rosdep
    nor the distribution has; what is called like the repository may be another package of it.
    """
    sources = tuple(sources)
    alone = not others and not any(each.listed for each in sources)
    return tuple(replace(each, only=_only(each, wanted.get(each.name, ()), asked, alone=alone)) for each in sources)


def _only(
    source: Source, asking: Sequence[tuple[str, Dependency]], asked: Collection[str], *, alone: bool
) -> tuple[str, ...]:
    found = tuple(dict.fromkeys(package for package, _ in asking))
    if all(asker.namespace == "ros" and not asker.file.endswith(_BUILDS) for _, asker in asking):
        return found
    there = packages_at(source.repo or "")
    if (
        alone
        and all(each.endswith(OF_MESSAGES) for each in found)
        and any(not each.endswith(OF_MESSAGES) for each in there)
    ):
        return (*found, *sorted(each for each in asked if each not in found and akin(each, source.name)))
    return ()
