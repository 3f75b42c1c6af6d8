"""The packages of a workspace in which a build tool of ROS says that it stopped."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.values.pattern import pattern

_NAMED = pattern(
    r"(?:Failed {1,8}<<< (?P<first>[A-Za-z][\w-]{0,199})(?=[\s\t]|$)"  # colcon, catkin build
    r"|<== Failed to process package '(?P<second>[A-Za-z][\w-]{0,199})'"  # catkin_make_isolated
    r"|(?:[^\n]{0,200}\s)?(?:Errors|Failed) {1,8}<< (?P<third>[A-Za-z][\w-]{0,199}):\w)"  # catkin build
)
"""How a tool that knows packages by their names tells of one that failed: lines of their output, read 2026-11-28.

https://github.com/colcon/colcon-output (colcon_output/event_handler/status.py),
https://github.com/catkin/catkin_tools (catkin_tools/execution/controllers.py),
https://github.com/ros/catkin (python/catkin/builder.py)
"""
_ENDED = pattern(
    r"(?:\[[\d.]{1,20}\] )?\([\w.-]{1,100}\) JobEnded: \{'identifier': '(?P<name>[\w-]{1,199})', 'rc': [1-9]"
)
"""The same in colcon's events.log."""
_MADE = pattern(r"make(?:\[\d{1,3}\])?: \*\*\* \[(?P<path>[^\] :\n]{1,300})/CMakeFiles/")
_ERROR = pattern(r"CMake (?:Deprecation )?(?P<kind>Error|Warning)\b")
_CONFIGURED = pattern(r"(?:^CMake Error at|^ {1,4})\s{0,2}(?P<path>\S{1,300})/CMakeLists\.txt:\d{1,6} \(")
_SOURCES = "/src/"
_MOST = 8
"""Most packages that are told of one step."""


def failed_packages(lines: Iterable[str], command: str) -> tuple[str, ...]:
    """Return the names of the packages in which a step failed; with catkin_make, their folders in its ``src``.

    catkin_make configures all packages as one project of CMake and names none; a folder may lie inside a package.
    ``command`` is the step's instruction.
    """
    said = list(lines)
    named = dict.fromkeys(name for line in said for name in _named(line))
    if not named and "catkin_make " in f"{command} ":
        named = dict.fromkeys((*_made(said), *_configured(said)))
    return tuple(named)[:_MOST]


def _named(line: str) -> Iterator[str]:
    if "<" in line and (found := _NAMED.match(line)):
        yield from (name for name in found.groups() if name)
    elif "JobEnded: " in line and (found := _ENDED.match(line)):
        yield found["name"]


def _made(said: Iterable[str]) -> Iterator[str]:
    """Yield the folders of the targets that make gave up."""
    for line in said:
        if "/CMakeFiles/" in line and (found := _MADE.match(line)):
            yield _below_sources(found["path"])


def _configured(said: Iterable[str]) -> Iterator[str]:
    """Yield the folders of the CMakeLists.txt files that errors of CMake, with the calls that led to them, name."""
    error = False
    for line in said:
        if found := _ERROR.match(line):
            error = found["kind"] == "Error"
        if error and (place := _CONFIGURED.match(line)):
            yield _below_sources(place["path"])


def _below_sources(path: str) -> str:
    """Return a folder relative to the workspace's ``src``, of a path that may be that in the image."""
    return path.partition(_SOURCES)[2] if path.startswith("/") and _SOURCES in path else path
