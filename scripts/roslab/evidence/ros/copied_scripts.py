"""Scripts that CMake installs among a package's programs without the right to be executed: ROS 2 starts none of them.

``install(DIRECTORY)`` and ``install(FILES)`` give it to no file by themselves, and colcon's ``--symlink-install`` hides
that on the author's machine. https://cmake.org/cmake/help/latest/command/install.html, 2026-11-28.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from itertools import islice, takewhile

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MOST = 40
"""Most scripts of a repository, calls of one file, and folders or files of one call."""
_INSTALL = pattern(r"^[ \t]*install[ \t]*\(\s*(DIRECTORY|FILES)\s([^()#]{1,4000})\)", re.IGNORECASE | re.MULTILINE)
_PROGRAMS = pattern(r"lib/(?:\$\{PROJECT_NAME\}|\$\{CMAKE_PROJECT_NAME\}|\w+)/?")
_PERMISSIONS = pattern(r"\b(?:(?:FILE_)?PERMISSIONS|USE_SOURCE_PERMISSIONS)\b")
_HERE, _PROJECT = "${CMAKE_CURRENT_SOURCE_DIR}/", "${PROJECT_SOURCE_DIR}/"
_TOOL = "ament_cmake"
_KEYWORD = pattern(r"[A-Z_]{4,}")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the name of each such script of a package that ament builds, with the line that installs it."""
    packages = {file.folder for file in repository.named("package.xml") if _TOOL in repository.read(file)}
    found: dict[str, Mention] = {}
    for file in repository.named("CMakeLists.txt") if packages else ():
        package = next((folder for folder in _above(file.folder) if folder in packages), None)
        if package is None or file.size > MAX_SIZE or places.aside(file.path):
            continue
        text = repository.read(file)
        for match in islice(_INSTALL.finditer(text), MOST) if "lib/" in text else ():
            line = text.count("\n", 0, match.start()) + 1
            for name in _scripts(match[1].upper(), match[2], file, package, repository):
                said = Mention(
                    topic="copied_script", value=name, source="code", file=file.path, line=line, text=match[1]
                )
                found.setdefault(name, said)
    yield from list(found.values())[:MOST]


def _scripts(kind: str, said: str, file: File, package: str, repository: Repository) -> Iterator[str]:
    """Yield the names of the scripts that a call of ``install`` copies; ``package``: the folder of their package."""
    words = said.replace('"', " ").split()
    at = next((index for index, word in enumerate(words) if word.upper() == "DESTINATION"), len(words))
    if _PERMISSIONS.search(said) or not _PROGRAMS.fullmatch(" ".join(words[at + 1 : at + 2])):
        return
    for word in islice(takewhile(lambda each: not _KEYWORD.fullmatch(each), words), MOST):
        folder = package if word.startswith(_PROJECT) else file.folder
        path = posixpath.normpath(posixpath.join(folder, word.removeprefix(_PROJECT).removeprefix(_HERE)))
        if kind == "FILES":
            found = [path] if repository.has(path) else []
        else:
            below = f"{path}/".removeprefix("./")
            found = [each.path for each in repository.files if path == "." or each.path.startswith(below)]
        yield from (posixpath.basename(each) for each in found if _starts(each, repository))


def _starts(path: str, repository: Repository) -> bool:
    """Tell whether a file names the program that reads it, as a script does that is started by its own name."""
    return repository.read_bytes(path, limit=2) == b"#!"


def _above(folder: str) -> Iterator[str]:
    """Yield a folder and those above it, the nearest first, down to the root's ``""``."""
    yield folder
    while folder:
        folder = posixpath.dirname(folder)
        yield folder
