"""Libraries that the repository carries as submodules, of which the build takes the distribution's instead."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.needs import code_needs
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_RELEASE = pattern(r"[-_.]?\d[\d.]*$")


def other_than_carried(
    evidence: Evidence, packages: Packages, target: Target, built: Collection[str]
) -> Iterator[Warning_]:
    """Yield a warning for each such library that CMake requires; one that is ``built``, or that CMake adds, is none."""
    carried = {plain(git.name.rpartition("/")[2]): git for git in evidence.sources if git.kind == "submodule"}
    for name in built:
        carried.pop(name, None)
    for asked in code_needs(evidence, packages) if carried else ():
        required = asked.namespace in {"cmake", "pkg-config"} and asked.strength == "declared"
        git = carried.get(plain(_RELEASE.sub("", asked.name))) if required and not places.aside(asked.file) else None
        perhaps = git and git.absent and target.ros_distro and asked.namespace == "cmake"  # it may be a package of ROS
        if git is None or perhaps or any(_adds(project, git.name) for project in evidence.cmake):
            continue
        if apt := " ".join(resolve(asked, target).apt):
            del carried[plain(git.name.rpartition("/")[2])]
            message = (
                f"the repository has {asked.name} as the submodule {git.name}, which nothing here builds: {apt} is "
            )
            yield warn(f"{message}taken instead; where the code needs the other, build it under `custom`", asked)


def _adds(project: CMakeProject, submodule: str) -> bool:
    """Tell whether CMake adds a folder of a submodule, which need not be checked out."""
    below = f"{submodule}/"
    inside = project.added and project.file.startswith(below)
    return inside or any(f"/{below}" in f"/{each}/" for each in project.adds)  # as written: below a variable, by ``..``
