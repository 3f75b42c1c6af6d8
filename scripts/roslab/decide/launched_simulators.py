"""The simulator that the launch file of the default command starts by a module, and that no package of ROS brings."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.model import Config
from roslab.decide.brought_launches import with_brought
from roslab.decide.decision import Warning_
from roslab.decide.launch_calls import started_launch
from roslab.decide.reasons import warn
from roslab.decide.system.own_packages import package_of_file
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile
from roslab.knowledge.launched_simulators import LaunchedSimulator, launched_simulators


def brought_simulators(
    evidence: Evidence, config: Config, command: tuple[str, ...] | str, ros_distro: str | None
) -> Iterator[tuple[Dependency, LaunchedSimulator]]:
    """Yield each that is installed by its file, with the import that asks for it.

    Not where roslab.yaml names its folder, nor for a ROS whose module looks for a release that no table has.
    """
    launch = started_launch(evidence, command) if evidence.launch and command and not config.compatible else None
    for used, simulator in _started(evidence, config, launch) if launch else ():
        if ros_distro in simulator.distros and not {name for name, _ in config.env} & {*simulator.variables}:
            yield used, simulator


def lacking_simulators(
    evidence: Evidence, config: Config, launch: LaunchFile, given: Collection[str], ros_distro: str | None
) -> Iterator[Warning_]:
    """Yield a warning for each simulator which the launch file, or one that it includes, starts and the image lacks.

    ``given``: the variables that are set, of which one may name its folder. Not where the author has apt install it.
    """
    for used, simulator in _started(evidence, config, launch):
        if ros_distro not in simulator.distros and not {*given} & {*simulator.variables}:
            message = (
                f"the default command starts the simulator {simulator.program}, which {used.name} looks for and does "
                f"not bring: install it under `custom` in roslab.yaml, from {simulator.address}"
            )
            yield warn(f"{message}, or set `command`", used)


def _started(evidence: Evidence, config: Config, launch: LaunchFile) -> Iterator[tuple[Dependency, LaunchedSimulator]]:
    """Yield each simulator that the launch file, or one that it includes, starts, and that nobody has installed."""
    files, told = {each.file for each in with_brought(evidence, launch)}, set[str]()
    own = {package_of_file(m.value) for m in evidence.mentions if m.topic == "own_package"}
    for used in evidence.code:
        simulator = launched_simulators().get(used.name) if used.namespace == "import" and used.file in files else None
        if simulator and simulator.program not in told and simulator.package not in {*config.apt, *own}:
            told.add(simulator.program)
            yield used, simulator
