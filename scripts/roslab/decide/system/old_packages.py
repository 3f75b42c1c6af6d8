"""Packages of apt that only older Ubuntus have: who installs them has one of those."""

from __future__ import annotations

from roslab.decide.system.cmake_version import has_it, needed_cmake
from roslab.decide.system.code_fits import misfits
from roslab.decide.system.old_names import outlived
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.apt_ubuntus import ubuntus_of
from roslab.knowledge.distros import ubuntu_released


def with_old_packages(evidence: Evidence, newest: str) -> tuple[str, Dependency] | None:
    """Return the newest Ubuntu up to one that has all that is installed by apt, and a package which that one lacks.

    ``None`` where it lacks none, or only what it has had under another name for long; where they have no Ubuntu in
    common: some are then for others; and where the code does not compile on what they have in common.
    """
    released = ubuntu_released()
    said = [each for each in evidence.prose if each.namespace == "apt" and ubuntus_of(each.name)]
    asked = {each.name: each for each in said if not outlived(each.name, evidence, released)}
    lacking = next((each for each in asked.values() if newest not in ubuntus_of(each.name)), None)
    if lacking is None:
        return None
    without, demand = misfits(evidence), needed_cmake(evidence)
    older = [name for name in released if released[name] < released[newest]]
    having = [ubuntu for ubuntu in older if all(ubuntu in ubuntus_of(name) for name in asked)]
    fitting = [ubuntu for ubuntu in having if not without.get(ubuntu) and has_it(ubuntu, demand)]
    return (max(fitting, key=released.__getitem__), lacking) if fitting else None
