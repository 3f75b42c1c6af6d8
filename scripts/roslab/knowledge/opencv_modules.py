"""Modules of OpenCV that lie in its second repository, under the same tags; Ubuntu's and ROS's packages have them."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass

REPOSITORY = "https://github.com/opencv/opencv_contrib.git"
NONFREE = "xfeatures2d/nonfree"
"""The header of what its makers leave out unless they are told: https://docs.opencv.org/4.5.5/d2/dca/group__xfeatures2d__nonfree.html."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Module:
    """A module, which ``opencv2/NAME.hpp`` and the headers in ``opencv2/NAME`` are of."""

    name: str
    needs: tuple[str, ...]
    """Others of that repository without which it is not built."""
    since: str
    """The first release that has it there, ``""`` where they all do."""


@cache
def opencv_modules() -> dict[str, Module]:
    """Return the modules by their names."""
    found = (
        Module(name=row["module"], needs=tuple(row["needs"].split()), since=row["since"])
        for row in rows("opencv_modules")
    )
    return {module.name: module for module in found}
