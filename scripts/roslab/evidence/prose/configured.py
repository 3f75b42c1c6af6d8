"""What a call of ``cmake`` in a text tells: its options, and the folder whose CMakeLists.txt it means."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from roslab.values.pattern import pattern

_OPTION = pattern(r"-D[A-Za-z_]\w*(?::[A-Z]+)?=[\w./+-]+")
_SEPARATE = pattern(r" -D +(?=[A-Za-z_])")
_BUILD_FOLDER = pattern(r"(?:^|/)build[\w-]*(?:/.*)?$")


def options_of(words: Sequence[str]) -> str:
    """Return the options of a call, ``-D GUI=ON`` written as one word."""
    joined = _SEPARATE.sub(" -D", " ".join(words)).split()
    return " ".join(word for word in joined if _OPTION.fullmatch(word))


def source_of(folder: str, words: Sequence[str]) -> str:
    """Return the folder that is configured from this one, ``.`` where the text begins.

    A folder whose name begins with ``build`` is one to build in, and so is any other from which ``cmake ..`` is called.
    """
    source = _BUILD_FOLDER.sub("", folder)
    if source == folder and {"..", "../"} & {*words}:
        source = posixpath.dirname(folder)
    return source or "."
