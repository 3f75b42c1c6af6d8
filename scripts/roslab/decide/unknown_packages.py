"""Packages of ROS from which the README runs something, and that nothing is known to bring."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.decide.renamed_launches import renamings
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.slips import meant
from roslab.decide.ros.sought import tried
from roslab.decide.ros.sought_by_pages import PLACEHOLDER
from roslab.decide.ros.source_names import plain
from roslab.decide.system.needs import started
from roslab.evidence.facts import Evidence
from roslab.knowledge.libraries import library
from roslab.knowledge.released import ever_released

MOST = 5
"""Most packages that a message names."""


def decide_unknown_packages(
    evidence: Evidence, config: Config, kind: Kind, sources: Sources, there: Iterable[str]
) -> Choice[None]:
    """Return a warning that names those which no package of the tree, no distribution and no clone is called like.

    ``there``: packages of apt. Not where a clone may hold them, whose packages nobody knows.
    """
    names = {name for name in (manifest.name for manifest in evidence.manifests) if name}
    names |= sources.names | tried(sources.sought).keys() | {source.name for source in sources.everything}
    known, apt = {plain(name) for name in names}, " ".join(there)
    unread = any(source.absent for source in evidence.sources) or sources.with_unknown_packages
    found = {
        each.name: each
        for each in (() if unread or config.compatible else started(evidence, kind))
        if each.strength == "prose" and each.file.startswith("README")
        if plain(each.name) not in known and not ever_released(each.name) and each.name.replace("_", "-") not in apt
        if not (PLACEHOLDER.search(each.name) or library("cmake", each.name, None))
    }
    if not found:
        return Choice(answer=None)
    own = {name for name in (manifest.name for manifest in evidence.manifests) if name}
    slips = {name: near[0] for name in found if len(near := meant(name, own)) == 1}
    told = tuple(
        warn(f"the README runs {name}, and {near} of the tree is meant: correct the name there", found.pop(name))
        for name, near in slips.items()
    )
    taken = {name: file for name, file in renamings(evidence) if name in found}
    told += tuple(
        warn(f"the README launches from {name}, and no package is called so: {file} is taken", found.pop(name))
        for name, file in taken.items()
    )
    if not found:
        return Choice(answer=None, warnings=told)
    more = f" and {len(found) - MOST} more" if len(found) > MOST else ""
    what = f"{', '.join([*found][:MOST])}{more}: nothing is known to bring a package of that name"
    hint = "these commands do not start; give its repository under `source` in roslab.yaml"
    first = next(iter(found.values()))
    return Choice(answer=None, warnings=(*told, warn(f"the README runs programs of {what}, and {hint}", first)))
