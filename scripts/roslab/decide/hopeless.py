"""A command of a page below the root whose package nothing lets compile: it is no reason to stop the build.

What the page at the root runs is what the repository is for. A page of one package among many runs what is for those
alone who have all that it needs: the software of a motor's maker.
"""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.decision import Decision, Unlinkable
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


def _of_package(line: str) -> str:
    """Return the package of which a call of ROS starts something, ``""`` for another command."""
    match = _STARTS.match(f"{line} ")
    return match[1] if match else ""
