"""A command of a page below the root whose package nothing lets compile: it is no reason to stop the build.

What the page at the root runs is what the repository is for. A page of one package among many runs what is for those
alone who have all that it needs: the software of a motor's maker. What ROS 2 launches of such a package stops at once,
whichever page runs it, so that another command of a page is meant before it.
"""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.candidate import LAUNCHERS
from roslab.decide.decision import Decision, Unlinkable
from roslab.decide.launch_calls import started_launch
from roslab.decide.programs import owner
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_STARTS = pattern(r"(?:roslaunch|rosrun|ros2 launch|ros2 run) ([A-Za-z]\w*) ")


def without_hopeless(decision: Decision, evidence: Evidence, config: Config) -> Evidence | None:
    """Return the evidence without what such pages start of such a package, ``None`` where the command may stay.

    What it lacks is looked for nowhere, and others of the tree compile without it.
    """
    said = next((each for each in decision.reasons if each.question == "command" and each.decisive), None)
    argv = decision.command
    if isinstance(argv, str) or config.command is not None or decision.dockerfile or not said or not decision.may_fail:
        return None
    started = _of_package(" ".join(argv))
    if not started or "/" not in (said.file or ""):
        return None
    folders = {m.file.rpartition("/")[0]: m.name for m in evidence.manifests if m.name}
    lacking = (each.file or "" for each in decision.warnings if isinstance(each, Unlinkable))
    stopped = {owner(file, folders) for file in lacking} & {folders.get(folder) for folder in decision.may_fail}
    if started not in stopped:
        return None

    def gone(mention: Mention) -> bool:
        return mention.topic == "command" and "/" in mention.file and _of_package(mention.value) in stopped

    mentions = tuple(mention for mention in evidence.mentions if not gone(mention))
    return replace(evidence, mentions=mentions) if len(mentions) < len(evidence.mentions) else None


def without_stopping(decision: Decision, evidence: Evidence, config: Config) -> Evidence | None:
    """Return the evidence without what pages launch of ROS 2 that starts a package which is left out of the build.

    ``None`` where the default command starts none. ``ros2 launch`` ends where a package of a node is not there, and
    ``roslaunch`` goes on: https://github.com/ros2/launch_ros (launch_ros/substitutions/executable_in_package.py) and
    https://github.com/ros/ros_comm (tools/roslaunch/src/roslaunch/launch.py), 2026-11-29.
    """
    taken = config.command is not None or decision.dockerfile
    if decision.kind != "ros2" or taken or not _stops(decision.command, decision, evidence):
        return None
    mentions = tuple(
        each
        for each in evidence.mentions
        if each.topic != "command" or not _stops(tuple(each.value.split()), decision, evidence)
    )
    return replace(evidence, mentions=mentions) if len(mentions) < len(evidence.mentions) else None


def starts_whole(decision: Decision, evidence: Evidence) -> bool:
    """Tell whether a page runs the default command, which starts something of ROS and none that is left out."""
    said = next((each for each in decision.reasons if each.question == "command" and each.decisive), None)
    run = said is not None and any((m.topic, m.file) == ("command", said.file) for m in evidence.mentions)
    return run and decision.command[0] in LAUNCHERS and not _stops(decision.command, decision, evidence)


def _stops(argv: tuple[str, ...] | str, decision: Decision, evidence: Evidence) -> bool:
    """Tell whether a command starts something of a package that is left out, or a launch file that does so."""
    if isinstance(argv, str):
        return False
    launch = started_launch(evidence, argv)
    asked = (*launch.dependencies, *launch.reached) if launch else ()
    needed = {each.name for each in asked if each.namespace == "ros" and each.strength != "optional"}
    return not needed.isdisjoint(decision.left_out) or _of_package(" ".join(argv)) in decision.left_out


def _of_package(line: str) -> str:
    """Return the package of which a call of ROS starts something, ``""`` for another command."""
    match = _STARTS.match(f"{line} ")
    return match[1] if match else ""
