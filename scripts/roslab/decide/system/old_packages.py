"""Packages of apt that only older Ubuntus have: who installs them has one of those."""

from __future__ import annotations

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.apt_ubuntus import ubuntus_of
from roslab.knowledge.distros import ubuntu_released


def with_old_packages(evidence: Evidence, newest: str) -> tuple[str, Dependency] | None:
    """Return the newest Ubuntu up to one that has all that is installed by apt, and a package which that one lacks.

    ``None`` where it lacks none, or where they have no Ubuntu in common: some are then for others.
    """
    asked = {each.name: each for each in evidence.prose if each.namespace == "apt" and ubuntus_of(each.name)}
    lacking = next((each for each in asked.values() if newest not in ubuntus_of(each.name)), None)
    released = ubuntu_released()
    older = [name for name in released if released[name] < released[newest]]
    fitting = [ubuntu for ubuntu in older if all(ubuntu in ubuntus_of(name) for name in asked)]
    return (max(fitting, key=released.__getitem__), lacking) if lacking and fitting else None
