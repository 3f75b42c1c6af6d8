"""Programs that the README runs and that only a build outside of the workspace makes."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.programs import outside_of_packages
from roslab.decide.reasons import page_of, warn
from roslab.evidence.facts import Evidence


def decide_outside(evidence: Evidence, config: Config, kind: Kind) -> Choice[None]:
    """Return a warning for the first such program: the workspace's own build leaves it out."""
    outside = {program.name for program in outside_of_packages(evidence, kind)} if kind in {"ros1", "ros2"} else set()
    said = (m for m in evidence.mentions if m.topic == "command" and m.source == "readme" and m.value.split())
    run = next((m for m in said if m.value.split()[0].rpartition("/")[2] in outside), None)
    if run is None or config.compatible:
        return Choice(answer=None)
    name = run.value.split()[0].rpartition("/")[2]
    message = f"{page_of(run.file)} runs {name}, which CMake compiles only outside of a workspace of ROS"
    message += ": it is not in the image"
    hint = "give `kind: cpp` in roslab.yaml to build the project by CMake alone"
    return Choice(answer=None, warnings=(warn(f"{message}; {hint}", run),))
