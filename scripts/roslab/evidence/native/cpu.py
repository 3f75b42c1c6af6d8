"""Compiler options for the processor of the machine that builds, with which programs stop on other machines."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_FILES = 300
"""Most CMake files that are searched, those nearest to the root first."""
MAX_SIZE = 64 * 1024
MAKEFILES = ("Makefile", "makefile", "GNUmakefile")
_NATIVE = pattern(r"^[^#\n]*?(-m(?:arch|cpu)=native)\b", re.MULTILINE)


_WHY = (
    " compiles for the processor of the machine that builds the image: on another one its programs may stop with an "
    "illegal instruction"
)


def read(repository: Repository) -> Iterator[tuple[str, str, int]]:
    """Yield what the author should know of each file's first such option: the message, the file and the line.

    Makefiles count where neither CMake nor ROS builds the tree.
    """
    for file in repository.once(build_files):
        text = repository.read(file)
        if "=native" in text and (match := _NATIVE.search(text)):
            yield f"{match[1]}{_WHY}", file.path, text.count("\n", 0, match.start(1)) + 1


def build_files(repository: Repository) -> list[File]:
    """Return the files that give the compiler its options, those nearest to the root first."""
    files = [*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake")]
    if not repository.named("CMakeLists.txt", "package.xml"):
        files = [*repository.named(*MAKEFILES), *repository.suffixed(".mk")]
    kept = (f for f in files if f.size <= MAX_SIZE and not places.test(f.path) and not places.example(f.path))
    once = {file.path: file for file in kept}.values()
    return sorted(once, key=lambda f: (places.vendored(f.path), f.path.count("/"), f.path))[:MAX_FILES]


def told(problems: Iterable[tuple[str, str | None, int | None]]) -> bool:
    """Tell whether ``read`` found such an option."""
    return any(message.endswith(_WHY) for message, _, _ in problems)
