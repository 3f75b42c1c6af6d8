"""Whether a launch file has Gazebo open its window, by way of Gazebo's own launch files."""

from __future__ import annotations

import re
from collections.abc import Callable

from roslab.values.pattern import pattern

_WORLD = pattern(
    r"<include\s[^<>]{0,600}?\$\(\s?find(?:-pkg-share)?\s+gazebo_ros\s?\)/launch/"
    r"(?:\w*world\.launch|gazebo\.launch\.py)[\"'][^<>]{0,300}>"
)
"""Their argument ``gui`` is true: https://github.com/ros-simulation/gazebo_ros_pkgs/tree/noetic-devel/gazebo_ros/launch
and, of ROS 2, https://github.com/ros-simulation/gazebo_ros_pkgs/tree/ros2/gazebo_ros/launch, read 2026-11-26."""
_PYTHON = pattern(r"[\"']gazebo_ros[\"'][\s\S]{0,300}?[\"'](?:/?launch/)?gazebo\.launch\.py[\"'][\s\S]{0,600}")
_ARG = r"<(?:arg|let)\s[^<>]{0,200}?\bname\s?=\s?[\"']%s[\"'][^<>]{0,300}>"
_VALUE = pattern(r"\b(?:value|default)\s?=\s?(?:\"([^\"]*)\"|'([^']*)')")
_NAMED = pattern(r"\$\((?:arg|var)\s+(\w+)\s?\)")
_WITHOUT = pattern(r"[\"']gui[\"']\s?[:,]\s?[\"']?(?:false|0)\b", re.IGNORECASE)
_BODY = pattern(r"<include\s[^<>]{0,600}[^/<>]>[^\0]{0,4000}?</include>")
"""What an include gives to another file."""
_INCLUDE = "IncludeLaunchDescription("
_HELD = pattern(rf"[ \t]*\w+[ \t]*=(?!.*{_INCLUDE[:-1]}).*")
_FALSE = frozenset({"false", "0"})
_MOST = 4
"""Most arguments that are followed, one of which gives the value of the next."""


def opens_window(text: str, conditional: Callable[[str, int, int], bool], *, python: bool) -> bool:
    """Tell whether a launch file includes one of Gazebo's, under no condition, and does not keep its window closed.

    ``text``: without its comments, ``conditional``: whether a condition decides about a part of it.
    """
    if "gazebo_ros" not in text:
        return False
    if python:
        found = _PYTHON.search(text)
        return bool(found and not _WITHOUT.search(found[0]) and not conditional(text, *_place(text, found)))
    for match in _WORLD.finditer(text):
        end = -1 if match[0].endswith("/>") else text.find("</include>", match.end())
        if not conditional(text, match.start(), match.end()) and not _closed(text, text[match.end() : max(end, 0)]):
            return True
    return False


def _place(text: str, found: re.Match[str]) -> tuple[int, int]:
    """Return where a file in Python includes Gazebo's: the next include, where a variable holds what it includes."""
    call = _HELD.fullmatch(text, text.rfind("\n", 0, found.start()) + 1, found.start()) and found[0].find(_INCLUDE)
    begin = found.start() if call is None or call < 0 else found.start() + call + len(_INCLUDE)
    return begin, begin


def _closed(text: str, given: str) -> bool:
    """Tell whether what an include is given keeps the window closed, itself or by the default of an argument."""
    said = _value("gui", given)
    for _ in range(_MOST):
        if said is None or not (name := _NAMED.search(said)):
            break
        said = _value(name[1], _BODY.sub("", text))
    return said is not None and said.strip().lower() in _FALSE


def _value(name: str, text: str) -> str | None:
    """Return the value or default that the first element for an argument has."""
    element = re.search(_ARG % re.escape(name), text)
    found = _VALUE.search(element[0]) if element else None
    return None if found is None else found[1] or found[2] or ""
