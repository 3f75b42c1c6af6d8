"""Clones that become packages of a workspace: those that a text makes in the workspace's ``src``."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Sequence

from roslab.knowledge.distros import distro
from roslab.values.pattern import pattern

_SOURCES = pattern(r"(?:^|/)[^/]*(?:ws|workspace|catkin|colcon|ros)[^/]*/src$", re.IGNORECASE)
_NAME = pattern(r"\w[\w.+-]*")


_IN_BUILD = pattern(r"[^/]/build[\w-]*/?$")
"""A folder in which CMake builds what the folder above it, whose name tells more, is."""


_PATH_TO = pattern(r"(?:^|/)path[/_-]to(?:[/_-]|$)", re.IGNORECASE)
"""``path/to/NAME`` is ``/path/to/NAME``: where the reader has it, only its end is known."""


def end_of(target: str) -> str:
    """Return the name of the folder that ``cd`` goes into by a path of the reader's, with the one above a ``build``."""
    return "/".join(target.rstrip("/").split("/")[-1 - bool(_IN_BUILD.search(target)) :])


def of_reader(target: str) -> bool:
    """Tell whether ``cd`` goes to a place of the reader's, which is none below the folder that the text is in."""
    return target.startswith(("/", "~", "$", "-")) or "<" in target or bool(_PATH_TO.search(target))


def through(target: str, cloned: Iterable[str]) -> str:
    """Return such a path from the folder of a clone on, ``""`` where it goes through none."""
    parts = target.rstrip("/").split("/")
    places = [parts.index(name) for name in cloned if name in parts]
    return "/".join(parts[max(places) :]) if places else ""


def below_sources(target: str) -> str:
    """Return what follows the ``src`` of a workspace in such a path: ``REPOSITORY/scripts``; ``""`` without one."""
    before, _, after = target.rstrip("/").rpartition("/src/")
    return after if of_packages(f"{before}/src") else ""


def longer(folder: str, whole: str) -> str:
    """Return the longer of two paths where both are of one folder, else the first."""
    return whole if folder and whole.endswith(f"/{folder}") else folder


def of_packages(folder: str) -> bool:
    """Tell whether ``cd`` goes into the ``src`` of a workspace; of ``cd src`` nothing else is known."""
    folder = folder.rstrip("/")
    return _of_workspace(folder) or folder in {"src", "./src"}


def _of_workspace(folder: str) -> bool:
    """Tell whether a folder is the ``src`` of a workspace by the name above it, which may be that of a distribution."""
    above, _, last = folder.rpartition("/")
    return bool(_SOURCES.search(folder)) or (last == "src" and distro(above.rpartition("/")[2].lower()) is not None)


def leaves_repository(target: str, folder: str, script: str) -> bool:
    """Tell whether ``cd`` in a script of the root leaves the repository, which lies in the ``src`` of a workspace."""
    return "/" not in script and not folder and target.rstrip("/") == ".."


def folder_after(url: str, words: Sequence[str], here: str) -> str:
    """Return the name of the folder that follows the address in the words of a clone, ``""`` where none does.

    ``here``: the folder that the text is in, which ``.`` means.
    """
    rest = words[words.index(url) + 1 :]
    given = [word for word in rest if not word.startswith("-")]
    if not rest or rest[0] != (given or [""])[0] or len(given) != 1:
        return ""  # options with values follow, or a sentence goes on
    name = posixpath.basename(posixpath.normpath(posixpath.join(here, given[0])))
    return name if _NAME.fullmatch(name) else ""


def beside(target: str, *, inside: bool) -> bool:
    """Tell whether a clone into ``target``, ``""`` for its own name, is one of the packages.

    ``inside``: the text is in such a folder.
    """
    there = inside and not target.startswith(("/", "~", "..", "$"))
    return there or _of_workspace(target.rpartition("/")[0])
