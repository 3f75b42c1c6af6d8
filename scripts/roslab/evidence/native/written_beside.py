"""What CMake writes while it compiles outside of its build folder: to the source, or to the user's home."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from roslab.evidence import places
from roslab.evidence.lex.cmake import Call, calls
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_FILES = 1_000
MAX_SIZE = 256 * 1024
_NAMES = frozenset({"set", "set_target_properties", "install", "file"})
_WORDS = ("OUTPUT_DIRECTORY", "OUTPUT_PATH", "DESTINATION", "DOWNLOAD")
_OLD = frozenset({"LIBRARY_OUTPUT_PATH", "EXECUTABLE_OUTPUT_PATH"})
"""They yield to those of today, which catkin sets: https://cmake.org/cmake/help/latest/variable/LIBRARY_OUTPUT_PATH.html"""
_OUTPUTS = frozenset({"CMAKE_LIBRARY_OUTPUT_DIRECTORY", "CMAKE_RUNTIME_OUTPUT_DIRECTORY"}) | _OLD
_OF_TARGETS = frozenset({"LIBRARY_OUTPUT_DIRECTORY", "RUNTIME_OUTPUT_DIRECTORY"})
_BESIDE = pattern(
    r"(?:\$ENV\{HOME\}|~|\$\{(?:PROJECT|CMAKE|CMAKE_CURRENT)_(?:SOURCE|LIST)_DIR\})(?!.*/\.\.(?:/|$))(?:/|$)"
)
"""Not above a package: there lies its workspace."""
_PLACES = ("$ENV{HOME}", "~", "_SOURCE_DIR}", "_LIST_DIR}")
"""Of these each such path has one."""


def found(repository: Repository) -> bool:
    """Tell whether a CMakeLists.txt, but for tests and examples, has what runs written there."""
    for file in repository.named("CMakeLists.txt")[:MAX_FILES]:
        text = repository.read(file) if file.size <= MAX_SIZE and not places.sample(file.path) else ""
        told = any(word in text for word in _WORDS) and any(place in text for place in _PLACES)
        if told and "rosbuild_init" not in text:
            by_catkin = text.count("\n", 0, text.find("catkin_package(")) + 1 if "catkin_package(" in text else 0
            written = (path for call in calls(text, _NAMES) for path in _written(call, by_catkin))
            if any(_BESIDE.match(path) for path in written):
                return True
    return False


def _written(call: Call, by_catkin: int) -> Iterator[str]:
    """Yield the folders and files that a call writes; ``by_catkin``: the line from which catkin has set the folders."""
    words = call.words
    if call.name == "set":
        yields = by_catkin and (call.line < by_catkin or not _OLD.isdisjoint(words[:1]))
        yield from words[1:2] if words and words[0] in _OUTPUTS and not yields else ()
    elif call.name == "file":
        yield from words[2:3] if words[:1] == ("DOWNLOAD",) else ()
    else:
        wanted = {"DESTINATION"} if call.name == "install" else _OF_TARGETS
        yield from (path for name, path in pairwise(words) if name in wanted)
