"""The ROS distribution of who installs by apt what only older Ubuntus have."""

from __future__ import annotations

from roslab.decide.system.old_names import outlived
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.apt_ubuntus import ubuntus_of
from roslab.knowledge.distros import distros


def by_packages(evidence: Evidence, ros: int) -> tuple[str, str, Dependency] | None:
    """Return the newest distribution whose Ubuntu has all that pages and scripts install, the reason, and its place.

    ``None`` where nothing of that tells of an Ubuntu, where none has all of it, and where the same is installed under
    its name for Python 3, too: then each is for another reader. A page keeps the name of a tool for long after its
    authors moved on.
    """
    names = {each.name for each in evidence.prose if each.namespace == "apt"}
    asked = {each.name: each for each in evidence.prose if each.namespace == "apt" and ubuntus_of(each.name)}
    found = {name: each for name, each in distros().items() if each.ros == ros and not each.never_ends}
    released = {each.ubuntu: each.released for each in found.values()}
    asked = {name: each for name, each in asked.items() if not outlived(name, evidence, released)}
    if not asked or any(name.replace("python-", "python3-", 1) in names - {name} for name in asked):
        return None
    having = [name for name in found if all(found[name].ubuntu in ubuntus_of(each) for each in asked)]
    if not having:
        return None
    best = max(having, key=lambda name: found[name].preference)
    first = next(iter(asked.values()))
    return best, f"no distribution is named, and Ubuntu {found[best].ubuntu} is the last with {first.name}", first
