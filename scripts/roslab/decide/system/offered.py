"""What a page or the author's CI installs by apt before it builds a library: offered where that library is built."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from roslab.config.model import Source
from roslab.decide.ros.source_names import address
from roslab.decide.system.by_hand import SCRIPTS
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def with_offered(
    built: Iterable[tuple[Source, Dependency]], clones: Iterable[GitSource], evidence: Evidence, apt: Collection[str]
) -> tuple[tuple[Source, Dependency], ...]:
    """Give each library the packages that are installed above it, in the file that builds it, but for those of ROS.

    ``clones``: what is built by hand, the best of each address last; ``apt``: what the image offers.
    """
    by_address = {address(git.url): git for git in clones}
    found = []
    for source, asked in built:
        git = by_address.get(address(source.repo or ""))
        names = _above(git, evidence) if git and source.build == "cmake" else ()
        more = tuple(name for name in names if name in apt and name not in source.depends)
        found.append((replace(source, offered=more), asked))
    return tuple(found)


def _above(git: GitSource, evidence: Evidence) -> tuple[str, ...]:
    """Return the packages of the lines above a clone, and of those below it in its own section, or its own script."""
    said = (*evidence.prose, *(each for recipe in evidence.dockerfiles for each in recipe.dependencies))
    here = [each for each in said if each.namespace == "apt" and each.file == git.file]
    clones = (*evidence.sources, *(clone for recipe in evidence.dockerfiles for clone in recipe.clones))
    after = min((each.line for each in clones if each.file == git.file and each.line > git.line), default=None)
    own = git.heading or git.file.endswith(SCRIPTS)
    names = (
        each.name
        for each in here
        if each.line < git.line or (own and each.heading == git.heading and (after is None or each.line < after))
    )
    return tuple(sorted({name for name in names if not name.startswith("ros-")}))
