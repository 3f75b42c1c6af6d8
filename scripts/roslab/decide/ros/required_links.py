"""What a page lists among the repositories that are required: its author's choice, where tables know another one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.decide.ros.included import MESSAGES
from roslab.decide.ros.source_names import SHORTEST, address, plain
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.ros_sources import ros_sources

_ASKED = ("declared", "used")


def required_links(
    evidence: Evidence, needed: Iterable[Dependency], known: AbstractSet[str], ros: int, distro: str
) -> Iterator[tuple[GitSource, Dependency]]:
    """Yield each link of such a list with what needs it: a package called like the repository, or beginning with that.

    Those with a branch or commit, or that no table knows: a bare link to what a table knows says no more than that. Not
    what is ``known``, nor a module of Python, which pip may bring.
    """
    links = [git for git in evidence.sources if git.kind == "link" and git.holds and plain(git.name) not in known]
    modules = {each.name for each in evidence.code if each.namespace == "import" and each.role != MESSAGES}
    of_ros = [each for each in needed if each.namespace in {"rosdep", "ros"}] if links else []
    lacking = {plain(each.name): each for each in of_ros if each.strength == "declared" or each.name not in modules}
    lacking = {name: each for name, each in lacking.items() if each.name not in known and each.strength in _ASKED}
    for git in links:
        name = plain(git.name)
        meant = [name] if name in lacking else []
        meant += [each for each in lacking if len(name) >= SHORTEST and each.startswith(f"{name}_")]
        tabled = {address(row.repo) for each in meant for row in ros_sources(lacking[each].name, ros, distro)}
        if meant and (git.ref or not tabled):
            yield git, lacking[meant[0]]
