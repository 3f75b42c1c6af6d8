"""Packages of Python whose programs are to be installed where ROS 2 looks: launch files or pages start them by it."""

from __future__ import annotations

from roslab.evidence.facts import Evidence

_RUN = ("ros2", "run")


def in_bin(evidence: Evidence) -> tuple[tuple[str, str], ...]:
    """Return folder and name of each that does not say where they go, and of which ``ros2`` is to start a program.

    One that nobody starts by ``ros2`` is left as it is: a program in ``bin`` is called by its name alone.
    """
    found = tuple((m.inside, m.value) for m in evidence.mentions if m.topic == "in_bin")
    if not found:
        return ()
    started = {package for launch in evidence.launch for package, _ in launch.nodes}
    started |= {mention.value for mention in evidence.mentions if mention.topic == "calls"}
    commands = (mention.value.split() for mention in evidence.mentions if mention.topic == "command")
    started |= {words[2] for words in commands if tuple(words[:2]) == _RUN and len(words) > 2}
    return tuple(each for each in found if each[1] in started)
