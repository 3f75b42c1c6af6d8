"""Clones in the workspace whose modules the code imports: colcon installs nothing that a plain Python project needs."""

from __future__ import annotations

from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.source_names import plain
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import released_for
from roslab.values.dataclass import replace


def with_imported(sources: Sources, evidence: Evidence, ros: int) -> Sources:
    """Return the sources, with those marked that a list or a page names and that are called like an imported module.

    No package that any distribution of that ROS released is one of them: such a module is ROS's.
    """
    if not any(source.listed for source in sources.sources):
        return sources
    used = {
        each.name
        for each in evidence.code
        if each.namespace == "import" and each.strength == "used" and not places.aside(each.file)
    }
    names = {plain(name) for name in used if not released_for(name, ros)}
    marked = tuple(
        replace(source, imported=True) if source.listed and plain(source.name) in names else source
        for source in sources.sources
    )
    return replace(sources, sources=marked)
