"""Launch files that no build of their package installs, so that ``ros2 launch`` does not find them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from roslab.evidence import places
from roslab.evidence.launch_file import LaunchFile
from roslab.evidence.ros.launch_globs import left_by_globs
from roslab.evidence.ros.only_programs import only_programs
from roslab.evidence.ros.unmade_nodes import COMMENT
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_ANY = pattern(
    r"\b(?:os\.walk|listdir|scandir|iterdir|isdir|rglob|GLOB)\b|\*\*|DIRECTORY\s+[\"']?(?:\.|\$\{\w+\}/?[\"']?\s)"
    r"|\$\{(?:CMAKE|CMAKE_CURRENT|PROJECT)_SOURCE_DIR\}/?[\"']?\s"
)
"""What takes files of any folder."""
_SHARES = pattern(r"\bDIRECTORY\b|\bFILES\b|\bINSTALL_TO_SHARE\b|\bdata_files\b")
"""What installs files that are no code; one of a package whose build has none tells nothing."""


def marked(
    launches: Iterable[LaunchFile], repository: Repository, packages: Mapping[str, str]
) -> tuple[LaunchFile, ...]:
    """Return the launch files, with those marked that lie in a folder which their package's build does not name.

    So are those that none of the patterns of a setup.py takes of a folder which it names.
    And those of a package whose build installs programs alone: they are started by their paths.
    ``packages`` are the names of the packages by their folders. Of ROS 1 none is: its workspace finds the source.
    """
    return tuple(_marked(each, repository, packages) if each.ros == 2 else each for each in launches)


def _marked(launch: LaunchFile, repository: Repository, packages: Mapping[str, str]) -> LaunchFile:
    folder = places.innermost(launch.file, packages)
    if folder is None:
        return launch
    if _left(launch.file, folder, repository, packages):
        return replace(launch, installed=False)
    return replace(launch, by_path=True) if only_programs(launch.file, folder, repository) else launch


def _left(path: str, folder: str, repository: Repository, packages: Mapping[str, str]) -> bool:
    inside = f"{folder}/" if folder else ""
    place, _, name = path[len(inside) :].rpartition("/")
    first = place.partition("/")[0]
    cmake, setup = (COMMENT.sub("", repository.read(f"{inside}{each}")) for each in ("CMakeLists.txt", "setup.py"))
    text = cmake or setup
    if not place or name in text or not _SHARES.search(text) or _ANY.search(text):
        return False
    # A package of Python is named for its modules, which lie elsewhere than what launch finds
    module = not cmake and repository.has(f"{inside}{first}/__init__.py") and first == packages[folder]
    if module:
        return not _in_module(place, text)
    named = re.search(rf"(?<![\w-]){re.escape(first)}(?![\w-])", text)
    return not named or (not cmake and left_by_globs(place, name, text))


def _in_module(place: str, text: str) -> bool:
    """Tell whether setup.py names a folder of its module: by its path, its parts, or behind a variable."""
    first, _, inside = place.partition("/")
    after = rf"/?(?:{re.escape(inside.partition('/')[0] or '*')}|\*)"
    by_name = rf"{re.escape(first)}(?:/|[\"'],\s*[\"'])"
    by_variable = rf"[(\[]\s*\w+\s*[,+]\s*[\"']{after}|[\"']\{{\w+\}}/{after}"
    return re.search(f"{by_name}|{by_variable}", text) is not None
