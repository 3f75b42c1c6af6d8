"""Packages of ROS 2 whose build installs programs and no launch files, which ``ros2 launch`` finds by path alone."""

from __future__ import annotations

import re

from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_COMMENT = pattern(r"#[^\n]*")
_WHOLE = pattern(r"(?<!\w)ament_package\s*\(")
_OF_CMAKE = r"(?:GNUInstallDirs|CTest|FetchContent|ExternalProject|Check\w+|CMake\w+|Find\w+)\s*\)"
_MORE = pattern(
    rf"\binstall\s*\((?!\s*(?:TARGETS|EXPORT)\b)|\binclude\s*\((?!\s*{_OF_CMAKE})|\badd_subdirectory\s*\(|"
    r"\b(?!ament_python_install_\w+)(?!install\s{0,40}\()(?=\w{0,80}install)\w{1,160}\s{0,40}\(|\bINSTALL_TO_SHARE\b"
)
"""What installs other files than programs and libraries, or may do so in a file or a macro of its own."""
_SHARES = pattern(r"share|prefix", re.IGNORECASE)
"""What a launch file calls the folder that its package installs its files into."""


def only_programs(path: str, folder: str, repository: Repository) -> bool:
    """Tell whether the CMakeLists.txt of a package installs no launch file, and one of its can do without.

    ``path`` is that of the launch file, ``folder`` that of its package. It cannot where it looks for files that were
    installed, and a build that names its folder may install it in any way. ``ros2 launch`` takes the path of a file
    (https://github.com/ros2/launch_ros, ros2launch/ros2launch/command/launch.py, 2026-11-27).
    """
    inside = f"{folder}/" if folder else ""
    place = path[len(inside) :].rpartition("/")[0]
    text = repository.read(f"{inside}CMakeLists.txt") if place else ""
    text = _COMMENT.sub("", text) if len(text) < MAX_SIZE else ""
    if not _WHOLE.search(text) or _MORE.search(text) or place.partition("/")[0] in text:
        return False
    return not _SHARES.search(repository.read(path))
