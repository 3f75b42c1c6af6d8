"""Libraries that CMake requires in a release which the Ubuntu does not have."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.model import BuildTool
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.system.names import Target
from roslab.evidence.dependency import Dependency
from roslab.knowledge.code_limits import satisfies, version_of


def too_old(
    asks: Iterator[tuple[str, Dependency]],
    target: Target,
    out: Collection[str],
    names: Collection[str],
    build_tool: BuildTool,
) -> Iterator[Warning_]:
    """Yield a warning for each library that CMake requires in a version that the Ubuntu's does not satisfy."""
    ros, ubuntu = bool(target.ros_distro), target.ubuntu or ""
    told: set[str] = set()
    for package, asked in asks:
        here = version_of(asked.name, ubuntu, ros=ros)
        built = plain(asked.name) in names  # from its source
        if package in out or built or not (here and asked.version) or asked.name in told:
            continue
        if not satisfies(asked.name, ubuntu, asked.version, ros=ros):
            told.add(asked.name)
            hint = "give its repository under `source` in roslab.yaml, or another base"
            what = f"{asked.target} is linked, which came with" if asked.target else "CMake requires"
            wanted = f"{what} {asked.name} {asked.version}, and this Ubuntu ({ubuntu}) has {here}"
            yield warn(f"{wanted}: {build_tool} will stop at {package}; {hint}", asked)
