"""Whether a Dockerfile has anything to do with ROS: one that has not says nothing of the distribution."""

from __future__ import annotations

import re
from collections.abc import Iterable

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


def speaks_of_ros(written: Iterable[Instruction], base: str) -> bool:
    """Tell whether any of its instructions, or its base, has or may have something of ROS."""
    return not _PLAIN.fullmatch(base) or any(_may_bring(each) for each in written)


def names_ros(written: Iterable[Instruction]) -> bool:
    """Tell whether any of its instructions names something of ROS."""
    return any(_OF_ROS.search(each.text) for each in written)


def _may_bring(instruction: Instruction) -> bool:
    text = instruction.text
    return bool(_OF_ROS.search(text)) or (instruction.name == "RUN" and bool(_SCRIPT.search(text)))
