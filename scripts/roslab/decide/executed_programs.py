"""Programs that the launch file of the default command starts beside its nodes, and that nothing is known to bring."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.brought_launches import with_brought
from roslab.decide.decision import Warning_
from roslab.decide.ros.source_names import address
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile
from roslab.knowledge.compiled import programs
from roslab.knowledge.released import ever_released
from roslab.knowledge.unpackaged_programs import unpackaged_programs
from roslab.values.pattern import pattern

_OF_ROS = pattern(
    r"(?:ament|catkin|colcon|gazebo|gz|ign|ros2?|rviz2?|rqt)(?:[_-].*|$)|ros[a-z]+|gz(?:server|client)|i?python[\d.]*"
)
"""Programs that come with packages of ROS, its simulators and Python."""


def executed_programs(evidence: Evidence, launch: LaunchFile) -> Iterator[Warning_]:
    """Yield a warning for each such program, and for a folder of the author's home in which one is started."""
    own = {name for project in evidence.cmake for name, _ in project.executables}
    own |= {name for project in evidence.python for name, _ in project.scripts}
    own |= {name for name, place in unpackaged_programs().items() if address(place) in _cloned(evidence)}
    told: set[str] = set()
    for file in with_brought(evidence, launch):
        for program, folder, line in file.executes:
            if program in told:
                continue
            told.add(program)
            if folder:
                message = f"the default command starts {program} in {folder}, a folder of the author's computer"
                then = "bring what is in it by `custom` in roslab.yaml, or set `command`"
                yield Warning_(message=f"{message}: {then}", file=file.file, line=line)
            elif not (program in own or _known(program)):
                message = f"the default command starts the program {program}, which nothing is known to bring"
                place = f" from {unpackaged_programs()[program]}" if program in unpackaged_programs() else ""
                then = f"bring it{place} by `custom` in roslab.yaml"
                yield Warning_(message=f"{message}: {then}", file=file.file, line=line)


def _cloned(evidence: Evidence) -> set[str]:
    return {address(git.url) for git in evidence.sources if git.kind != "link"}


def _known(program: str) -> bool:
    from roslab.knowledge.base_programs import base_programs  # noqa: PLC0415 - few programs execute others

    packaged = program in programs() or program in base_programs() or ever_released(program)
    return packaged or bool(_OF_ROS.fullmatch(program)) or program.endswith(".py")
