"""The packages of the plugins that a saved configuration of rviz (``.rviz``) loads: displays, panels and tools.

``Class: jsk_rviz_plugin/BoundingBoxArray``; one that is not there is shown as an error, and rviz goes on.
https://wiki.ros.org/rviz/UserGuide, https://github.com/ros2/rviz (docs/plugin_development.md), read 2026-11-28.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.lex.lines import matching_lines
from roslab.values.pattern import pattern

_CLASS = pattern(r"[ \t]{0,99}(?:-[ \t]{1,9})?Class:[ \t]{1,9}[\"']?([A-Za-z]\w{1,60})(?:/|::)[A-Za-z]\w+")
_OWN = frozenset({"rviz", "rviz_common", "rviz_default_plugins", "rviz2"})
"""What rviz itself has."""


def named(text: str) -> Iterator[tuple[str, int]]:
    """Yield each such package once, with its place in the text."""
    told = set(_OWN)
    for match in matching_lines(_CLASS, text, "Class:"):
        if match[1] not in told:
            told.add(match[1])
            from roslab.knowledge.plugin_classes import plugin_package  # noqa: PLC0415 - few trees name plugins

            if package := plugin_package(match[1]):
                yield package, match.start(1)
