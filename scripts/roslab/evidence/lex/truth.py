"""Whether a condition holds where an image is compiled: by GCC, on Linux, optimised, for ARM of 64 bits.

``None`` where that is not known: for what a build finds out by itself, and for names that somebody may set.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from roslab.knowledge.x86_only import x86_only
from roslab.values.pattern import pattern

Truth = bool | None
_VARIABLES = {
    "CMAKE_SYSTEM_PROCESSOR": "aarch64",
    "CMAKE_HOST_SYSTEM_PROCESSOR": "aarch64",
    "CMAKE_SYSTEM_NAME": "Linux",
    "CMAKE_HOST_SYSTEM_NAME": "Linux",
    "CMAKE_C_COMPILER_ID": "GNU",
    "CMAKE_CXX_COMPILER_ID": "GNU",
    "CMAKE_BUILD_TYPE": "Release",
    "CMAKE_SIZEOF_VOID_P": "8",
}
_ON = frozenset(
    (
        *(
            "UNIX",
            "LINUX",
            "CMAKE_HOST_UNIX",
            "CMAKE_HOST_LINUX",
            "CMAKE_COMPILER_IS_GNUCC",
            "CMAKE_COMPILER_IS_GNUCXX",
        ),
        *("ON", "TRUE", "YES", "1"),
    )
)
_OFF = frozenset(
    {
        "MSVC",
        "WIN32",
        "APPLE",
        "ANDROID",
        "CYGWIN",
        "MINGW",
        "IOS",
        "EMSCRIPTEN",
        "CMAKE_HOST_WIN32",
        "CMAKE_HOST_APPLE",
        "OFF",
        "FALSE",
        "NO",
        "0",
    }
)
_FOUND = pattern(r"(?!.*(?:SSE|AVX|SIMD|NEON))\w+_FOUND", re.IGNORECASE)
_MACROS_ON = pattern(
    r"__GNUC__|__GNUG__|_*linux_*|_*unix_*|__cplusplus|NDEBUG|__aarch64__|__ARM_NEON|__ARM_ARCH|__LP64__"
)
_MACROS_OFF = pattern(
    r"_?WIN(?:32|64)|_MSC_VER|__APPLE__|__MACH__|__MINGW(?:32|64)__|__CYGWIN__|__ICC|__INTEL_COMPILER|__clang__|"
    r"__ANDROID__|__EMSCRIPTEN__|__CUDA_ARCH__|_M_(?:X64|IX86|AMD64)|__arm__"
)
_DEFINED = pattern(r"defined\s*\(\s*(\w+)\s*\)|defined\s+(\w+)")
_ONE = pattern(r"(!?)\s*<(\w+)>|([01])")
_LONGEST = 500


def cmake_holds(condition: str, unset: Callable[[str], bool]) -> Truth:
    """Tell whether a condition of CMake holds, as ``lex.cmake`` gives it; ``unset``: nothing sets such a variable."""
    if condition.startswith("NOT (") and condition.endswith(")"):
        return _not(cmake_holds(condition[len("NOT (") : -1], unset))
    each = _OR.split(condition[:_LONGEST])
    return _any(_all(_term(term, unset) for term in _AND.split(part)) for part in each)


def _term(written: str, unset: Callable[[str], bool]) -> Truth:
    words = written.split()
    if words[:1] == ["NOT"]:
        return _not(_term(" ".join(words[1:]), unset))
    if len(words) == 2:
        truths = {"ON": True, "OFF": False, "DEFINED": False if words[1].startswith("ENV{") else None}
        return truths.get(words[0])
    name = words[0].removeprefix("${").removesuffix("}") if words else ""
    return _single(name, unset) if len(words) == 1 else _comparison(_VARIABLES.get(name), words[1:])


def _single(name: str, unset: Callable[[str], bool]) -> Truth:
    if name in _ON or name in _VARIABLES or _FOUND.fullmatch(name):
        return True
    return False if name in _OFF or unset(name) else None


def _comparison(value: str | None, words: list[str]) -> Truth:
    """Compare with a value: ``MATCHES x86``."""
    if value is None or len(words) < 2:
        return None
    asked = "".join(words[1:])[:_LONGEST]
    if words[0] != "MATCHES":
        return asked == value if words[0] in {"STREQUAL", "EQUAL"} else None
    try:
        return bool(re.search(asked, value))
    except re.error:
        return None


_OF_TOOL = pattern(
    r"(?:DEFINED )?(?:(CATKIN_DEVEL_PREFIX|catkin_FOUND)|(ament_cmake_FOUND)|(ENV\{ROS_(?:VERSION|DISTRO)\}))|"
    r"[\"']?\$ENV\{ROS_VERSION\}[\"']? (?:STREQUAL|EQUAL|VERSION_EQUAL) [\"']?([12])[\"']?"
)
"""What a workspace of catkin sets or finds; one of ament; any; the ROS that it asks for."""
_OR = pattern(r"\s+OR\s+")
_AND = pattern(r"\s+AND\s+")


def workspace_holds(condition: str, ros: int) -> Truth:
    """Tell whether a condition holds in a workspace of ROS 1 or 2; ``None`` where the build tool does not decide it.

    https://docs.ros.org/en/noetic/api/catkin/html/dev_guide/generated_cmake_api.html
    """
    if condition.startswith("NOT (") and condition.endswith(")"):
        return _not(workspace_holds(condition[len("NOT (") : -1], ros))
    each = _OR.split(condition[:_LONGEST])
    return _any(_all(_of_tool(term, ros) for term in _AND.split(part)) for part in each)


def _of_tool(written: str, ros: int) -> Truth:
    bare = written.removeprefix("NOT ")
    match = _OF_TOOL.fullmatch(bare)
    if match is None:
        return None
    holds = match[3] is not None or ros == (1 if match[1] else 2 if match[2] else int(match[4]))
    return holds == (bare == written)


def macros_hold(condition: str, defined: Callable[[str], bool]) -> Truth:
    """Tell whether the condition of an ``#if`` holds; ``defined``: of other names, whether the build defines them."""
    text = _DEFINED.sub(lambda match: f"<{match[1] or match[2]}>", condition[:_LONGEST].partition("//")[0])
    if "(" in text:
        return None
    return _any(_all(_macro(word.strip(), defined) for word in part.split("&&")) for part in text.split("||"))


def _macro(written: str, defined: Callable[[str], bool]) -> Truth:
    match = _ONE.fullmatch(written)
    if match is None:
        return None
    if match[3]:
        return match[3] == "1"
    name = match[2]
    if _MACROS_OFF.fullmatch(name) or x86_only("macro").fullmatch(name):
        truth: Truth = False
    else:
        truth = True if _MACROS_ON.fullmatch(name) or defined(name) else None
    return _not(truth) if match[1] else truth


def _not(truth: Truth) -> Truth:
    return None if truth is None else not truth


def _any(each: Iterable[Truth]) -> Truth:
    found = set(each)
    return True if True in found else None if None in found else False


def _all(each: Iterable[Truth]) -> Truth:
    found = set(each)
    return False if False in found else None if None in found else True
