"""The folder that a CMakeLists.txt has programs written to."""

from __future__ import annotations

import posixpath

from roslab.values.pattern import pattern

_OUTPUT = pattern(
    r"^(?:\$\{((?:CMAKE|PROJECT|CMAKE_CURRENT)_(?:SOURCE|BINARY)_DIR)\})?((?:/|(?<!\})(?=[\w.{]))[\w./{}-]*|)$"
)
_PROCESSOR = pattern(r"\$\{CMAKE_(?:HOST_)?SYSTEM_PROCESSOR\}")
PROCESSOR = "{processor}"
"""Stands in a folder for the name that CMake gives the processor, as ``uname -m`` does."""


def output_folder(written: str, folder: str) -> str | None:
    """Return a folder for programs; ``None`` if it is not known.

    ``source/…`` is relative to the root of the repository, ``top/…`` to the folder of the top-level CMakeLists.txt,
    ``build/…`` to the build folder's part for the root of the repository, and ``beside/…`` to the folder that it is in.
    """
    known = written.replace("${CMAKE_INSTALL_BINDIR}", "bin").replace("${CMAKE_SYSTEM_NAME}", "Linux")
    match = _OUTPUT.match(_PROCESSOR.sub(PROCESSOR, known).rstrip("/"))
    if match is None:
        return None
    variable, rest = match[1] or "", match[2].strip("/")
    side = "build" if "BINARY" in variable or not variable else "source"
    if variable in {"CMAKE_SOURCE_DIR", "CMAKE_BINARY_DIR"}:
        side, folder = "top" if side == "source" else "build", ""
    place = posixpath.normpath(posixpath.join(side, folder, rest))
    if place.partition("/")[0] == side:
        return place
    # The author's build folder is in the tree, the image's beside it
    return f"beside/{place}" if side == "build" and not place.startswith((".", "/")) else None
