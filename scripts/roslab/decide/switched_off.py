"""The default command without what its launch file includes of packages that nothing brings, where it has a switch."""

from __future__ import annotations

import shlex

from roslab.config.model import Config
from roslab.decide.command import Command
from roslab.decide.decision import Choice, Warning_
from roslab.decide.launch_calls import started_launch
from roslab.decide.launch_needs import packages_lacking
from roslab.decide.ros.clones import clones
from roslab.decide.ros.source_names import akin, plain
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def without_what_is_lacking(
    evidence: Evidence, config: Config, command: Choice[Command], ros_distro: str | None
) -> tuple[Evidence, Choice[Command]]:
    """Return the evidence and the command with ``ARGUMENT:=false`` for each such package; as they are without one.

    Only where all that the launch file lacks can be switched off so, and nothing that is cloned may be one of them.
    """
    argv = command.answer.command
    launch = None if isinstance(argv, str) or config.command is not None else started_launch(evidence, argv)
    if isinstance(argv, str) or launch is None or not launch.switches or command.answer.given:
        return evidence, command
    lacking = {asked.name: asked for asked in packages_lacking(evidence, config, argv, ros_distro)}
    off = dict(launch.switches)
    given = {word.partition(":=")[0] for word in argv}
    cloned = {git.name for git in clones(evidence, ros_distro)} | {source.name for source in config.source}
    perhaps = any(akin(name, other) or plain(name) in plain(other) for name in lacking for other in cloned)
    if not lacking or not off.keys() >= lacking.keys() or perhaps or not given.isdisjoint(off.values()):
        return evidence, command
    words = tuple(dict.fromkeys(f"{off[name]}:=false" for name in lacking))
    names, line = ", ".join(lacking), shlex.join((*argv, *words))
    told = f"the default command is started with {' '.join(words)}, without {names}, which nothing is known to bring"
    first = next(iter(lacking.values()))
    message = f"{told}: to start that too, give its repository under `source` and set `command` in roslab.yaml"
    reasons = (
        replace(each, answer=line, reason=f"{each.reason}; without {names}") if each.decisive else each
        for each in command.reasons
    )
    optional = tuple(
        replace(asked, strength="optional") if asked.name in lacking else asked for asked in launch.dependencies
    )
    left = replace(launch, dependencies=optional)
    launched = tuple(left if each.file == launch.file else each for each in evidence.launch)
    chosen = Choice(
        answer=replace(command.answer, command=(*argv, *words)),
        reasons=tuple(reasons),
        warnings=(*command.warnings, Warning_(message=message, file=first.file, line=first.line)),
    )
    return replace(evidence, launch=launched), chosen
