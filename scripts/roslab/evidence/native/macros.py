"""The families of CMake macros that a call belongs to or finds: catkin's, ament's, rosbuild's, CUDA's."""

from __future__ import annotations

from functools import cache

from roslab.evidence.lex.cmake import Call
from roslab.values.pattern import pattern

_FAMILIES = (
    ("cuda", pattern(r"cuda_add")),
    ("rosbuild", pattern(r"rosbuild_(?!prepare_qt4)")),  # which is qt_build's, for packages of catkin as well
    ("ament", pattern(r"ament_(?!target_dependencies)|autoware_package|rosidl_generate_interfaces")),
    ("catkin", pattern(r"catkin_package|catkin_simple|cs_")),
)
_FOUND = (
    ("catkin", pattern(r"catkin(?:_simple)?$")),
    ("ament", pattern(r"ament_|autoware_cmake$")),
)
_CUDA = pattern(r"(?:CUDA|CUDAToolkit|CUDNN|TensorRT)$")
_LANGUAGES = frozenset({"project", "enable_language"})


def macros(call: Call) -> dict[str, None]:
    """Return them in their order."""
    name, words = call.name, call.words
    found = _families(name)
    if name == "find_package" and words and not call.conditions:
        found = found | dict.fromkeys(family for family, pattern in _FOUND if pattern.match(words[0]))
        if _CUDA.match(words[0]) and "REQUIRED" in words:
            found["cuda"] = None
    if name in _LANGUAGES and "CUDA" in words:
        found = found | {"cuda": None}
    return found


@cache
def _families(name: str) -> dict[str, None]:
    """Return the families that have a macro; a tree calls few of them, thousands of times."""
    return dict.fromkeys(family for family, pattern in _FAMILIES if pattern.match(name))
