"""The distribution whose name the branches of listed repositories have: a list is made for one of them."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.decide.ros.distro_weights import Weight
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros


def listed_branches(evidence: Evidence, ros: int) -> Iterator[Reason]:
    """Yield the distribution, if it is one alone, that branches of lists are called by; rolling tells of none."""
    listed = [git for git in evidence.sources if git.kind == "vcs" and git.ref in distros()]
    of_ros = [git for git in listed if distros()[git.ref or ""].ros == ros and not distros()[git.ref or ""].never_ends]
    if len({git.ref for git in of_ros}) == 1:
        number = "a listed repository" if len(of_ros) == 1 else f"{len(of_ros)} listed repositories"
        first, name = of_ros[0], of_ros[0].ref or ""
        yield because("ros_distro", name, f"the branch of {number} has its name", first, weight=Weight.ADDRESS)
