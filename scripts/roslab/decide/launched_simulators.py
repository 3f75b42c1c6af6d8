"""The simulator that the launch file of the default command starts by a module, and that no package of ROS brings."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.model import Config
from roslab.decide.brought_launches import with_brought
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile
from roslab.knowledge.launched_simulators import launched_simulators


def lacking_simulators(
    evidence: Evidence, config: Config, launch: LaunchFile, given: Collection[str]
) -> Iterator[Warning_]:
    """Yield a warning for each simulator which the launch file, or one that it includes, starts and the image lacks.

    ``given``: the variables that are set, of which one may name its folder. Not where the author has apt install it.
    """
    files, told = {each.file for each in with_brought(evidence, launch)}, set[str]()
    for used in evidence.code:
        simulator = launched_simulators().get(used.name) if used.namespace == "import" and used.file in files else None
        if simulator is None or simulator.program in told:
            continue
        told.add(simulator.program)
        if simulator.package not in config.apt and not {*given} & {*simulator.variables}:
            message = (
                f"the default command starts the simulator {simulator.program}, which {used.name} looks for and does "
                f"not bring: install it under `custom` in roslab.yaml, from {simulator.address}"
            )
            yield warn(f"{message}, or set `command`", used)
