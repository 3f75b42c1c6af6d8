"""The CMake that packages ask for which the table of ROS sources clones: the image has it before they are read."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def cmake_of_sources() -> dict[tuple[str, int], str]:
    """Return the version of CMake by the package and the number of its ROS, where a usual Ubuntu's is too old."""
    return {(row["package"], int(row["ros"])): row["cmake"] for row in rows("cmake_of_sources")}
