"""Options that are left without their values, where those went because the reader fills them in."""

from __future__ import annotations

from collections.abc import Collection, Sequence

ROS_ARGUMENTS = "--ros-args"
RULES = frozenset({"-p", "--param", "-r", "--remap"})
"""Options of a node whose value is ``NAME:=VALUE``."""
_VALUED = frozenset({*RULES, "--params-file", "--log-level", "--log-config-file", "--log-file-name", "-e", "--enclave"})
"""Options that end the node where they have no value.

Source: ros2/rcl, rcl/src/rcl/arguments.c and include/rcl/arguments.h, 2026-11-27."""
_END = "--"
"""What ends the arguments of ROS."""


def without_bare(words: Sequence[str], emptied: Collection[int] = ()) -> tuple[str, ...]:
    """Return a command without the options whose values are gone; ``emptied`` are the places of those that may be.

    Behind ``--ros-args`` that is each which needs a value and has none, and ``--ros-args`` itself where nothing follows
    it. The option of roslaunch of that name lists the arguments of a launch file.
    """
    kept = [word for at, word in enumerate(words) if at not in emptied or _value(words, at)]
    if ROS_ARGUMENTS not in kept or kept[0] == "roslaunch":
        return tuple(kept)
    found: list[str] = []
    of_ros = False
    index = 0
    while index < len(kept):
        word, value = kept[index], _value(kept, index)
        index += 1
        if of_ros and word in _VALUED:
            if value and (word not in RULES or ":=" in value):
                found += (word, value)
            index += bool(value)
            continue
        if word == ROS_ARGUMENTS or (word == _END and of_ros):
            ended, of_ros = of_ros, word == ROS_ARGUMENTS
            if ended and found[-1:] == [ROS_ARGUMENTS]:
                found.pop()
                if word == _END:
                    continue
        found.append(word)
    return tuple(found[:-1] if of_ros and found[-1] == ROS_ARGUMENTS else found)


def _value(words: Sequence[str], at: int) -> str:
    """Return the word behind an option, ``""`` where that is none or another option."""
    word = words[at + 1] if at + 1 < len(words) else ""
    return "" if word.startswith("-") else word
