"""Repositories of ROS that hold no package but submodules, which the image clones and builds."""

from __future__ import annotations

from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import folders_of
from roslab.evidence.facts import Evidence, Mention

_TOOLS = frozenset({"catkin_make", "catkin_tools", "catkin_make_isolated", "colcon"})


def only_in_submodules(evidence: Evidence) -> Mention | None:
    """Return where a page or a script builds a workspace, if the tree has no manifest and clones lie in it."""
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.value in _TOOLS and m.source != "dockerfile")
    return None if evidence.manifests or not _cloned(evidence) else next(said, None)


def may_fail_in(evidence: Evidence, packages: Packages, failing: tuple[str, ...]) -> tuple[str, ...]:
    """Return the folders in which the build may fail: those of these packages, and of what nobody has read yet."""
    return folders_of(packages, failing) or (_cloned(evidence) if only_in_submodules(evidence) else ())


def _cloned(evidence: Evidence) -> tuple[str, ...]:
    return tuple(git.name for git in evidence.sources if git.kind == "submodule" and git.absent)
