"""Sentences that name a program only as the title of the commands below them: ``#### Run `slam`:`` above a block."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.evidence.prose.headings import fence, heading_of
from roslab.evidence.prose.telling import SIGNS, telling

_STARTING = (
    *("roslaunch", "rosrun", "ros2", "gz ", "ign ", "gazebo ", ".wbt", "run", "torchrun", "accelerate"),
    *(".sh", ".bash", "streamlit", "octave", "jupyter", "python", "./", "build/", "/lib/", "bin/"),
)
_STARTS = tuple(sign for sign in SIGNS if sign[0] in _STARTING)
"""Signs of a command that starts something; others install, fetch or compile."""


def titles_commands(lines: Sequence[str], index: int) -> bool:
    """Tell whether a line outside of a block is the title of a block that starts something.

    A heading is, of the blocks up to the next heading; another line that ends with a colon, of the one right below.
    ``index`` is the number of the line, from 1.
    """
    below = lines[index] if index < len(lines) else ""
    heading = heading_of(lines[index - 1], below) is not None
    if not (heading or lines[index - 1].rstrip().endswith(":")):
        return False
    underlined = heading and not lines[index - 1].startswith("#")
    fenced = False
    for place, line in enumerate(lines[index + underlined :], index + underlined):
        if fence(line):
            if fenced and not heading:
                return False
            fenced = not fenced
        elif fenced:
            if telling(line, _STARTS):
                return True
        elif line.strip() and (not heading or heading_of(line, lines[place + 1] if place + 1 < len(lines) else "")):
            return False
    return False
