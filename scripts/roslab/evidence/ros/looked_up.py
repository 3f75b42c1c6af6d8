"""Packages of ROS whose folder programs look for while they run: ``ros::package::getPath("maps")``, in Python too.

No compiler asks for them, so that many package.xml files forget them; a program that needs the maps or models of one
ends at once.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.lines import matches_at
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 1_000
"""Most files that are opened, those nearest to the root first."""
_CODE = (".cpp", ".cc", ".cxx", ".hpp", ".h", ".hh")
_LOOKED_UP = pattern(
    r"(?:ros::package::getPath|ament_index_cpp::get_package_share_directory)\(\s{0,9}\"([a-z][a-z0-9_]{1,60})\"\s{0,9}\)"
)
"""http://docs.ros.org/en/noetic/api/roslib/html/c++/namespaceros_1_1package.html,
https://github.com/ament/ament_index/blob/rolling/ament_index_cpp/README.md, read 2026-11-28."""
_IN_PYTHON = pattern(
    r"\b(?:get_path|get_pkg_dir|get_package_share_directory|get_package_share_path)\(\s{0,9}"
    r"[\"']([a-z][a-z0-9_]{1,60})[\"']\s{0,9}[,)]"
)
"""https://docs.ros.org/en/independent/api/rospkg/html/rospack.html,
https://docs.ros.org/en/api/roslib/html/python/roslib.packages-module.html, read 2026-11-28."""
_PYTHON = ("rospkg", "roslib", "ament_index_python")
"""Modules without one of which a function of such a name is another one."""
_ASKED = pattern(r"get(?:Path|_package_share)")
"""What both of C++ have, which takes one look."""
_BEGINNINGS = ("ros::package::getPath", "ament_index_cpp::get_package_share_directory")


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return each package once, at the first place that looks for it, but in a comment or a test."""
    found: dict[str, Dependency] = {}
    files = [f for f in repository.suffixed(*_CODE, ".py") if f.size <= MAX_SIZE and not places.aside(f.path)]
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        for match in _matches(file, text):
            before = text[text.rfind("\n", 0, match.start()) + 1 : match.start()]
            comment = "#" in before if file.name.endswith(".py") else "//" in before or before.lstrip().startswith("*")
            if match[1] not in found and not comment:
                line = text.count("\n", 0, match.start()) + 1
                found[match[1]] = Dependency(
                    namespace="ros", name=match[1], strength="used", file=file.path, line=line, role="exec"
                )
    return tuple(found.values())


def _matches(file: File, text: str) -> Iterable[re.Match[str]]:
    if not file.name.endswith(".py"):
        return matches_at(_LOOKED_UP, text, *_BEGINNINGS) if _ASKED.search(text) else ()
    return _IN_PYTHON.finditer(text) if any(word in text for word in _PYTHON) else ()
