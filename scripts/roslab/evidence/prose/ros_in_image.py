"""Whether a Dockerfile has anything to do with ROS: one that has not says nothing of the distribution."""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.evidence.facts import RosInImage
from roslab.evidence.lex.dockerfile import Instruction
from roslab.values.pattern import pattern

_OF_ROS = pattern(r"(?<![a-z])(?:ros(?!pkg)|catkin(?!_pkg|-pkg)|colcon|ament)", re.IGNORECASE)
"""A word of it; rospkg and catkin_pkg are packages of pip, which bring no distribution."""
_SCRIPT = pattern(
    r"(?<![\w./-])(?!\S{0,200}(?:conda|forge|mamba))\S{1,200}\.(?:sh|bash)(?!\w)|\bansible", re.IGNORECASE
)
"""A step that may install anything, in a file that is not read here; conda's installers bring nothing of ROS."""
_PLAIN = pattern(r"(?:[\w.-]+/)*(?:cuda|cudagl|opengl|ubuntu|debian|python|pytorch|tensorflow)(?:[:@].*)?")
"""An image that has nothing of ROS; one that the author built may have it."""


def ros_of(written: Iterable[Instruction], base: str) -> RosInImage:
    """Tell whether any of its instructions names something of ROS, or else it or its base may bring it."""
    written = tuple(written)
    if any(_OF_ROS.search(each.text) for each in written):
        return "named"
    runs = any(each.name == "RUN" and _SCRIPT.search(each.text) for each in written)
    return "possible" if runs or not _PLAIN.fullmatch(base) else "none"
