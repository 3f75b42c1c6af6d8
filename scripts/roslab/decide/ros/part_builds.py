"""Builds of a page that take only a part of the workspace, and the whole build that follows them.

A page that builds its messages first, or the one package that it is about, has its reader build the rest later. The
image builds once, and all that such a page builds.
"""

from __future__ import annotations

from collections.abc import Sequence

from roslab.config.model import BuildTool
from roslab.evidence.facts import Evidence, Mention
from roslab.values.pattern import pattern

ONLY = pattern(r"-DCATKIN_WHITELIST_PACKAGES(?::[A-Z]+)?=.*")
"""What limits catkin_make to some packages, until a later call gives another value, or none.

http://docs.ros.org/en/noetic/api/catkin/html/user_guide/variables.html, 2026-11-27.
"""
_PART = frozenset({"--pkg", "--from-pkg", "--only-pkg-with-deps", "--packages-select", "--packages-up-to", "--this"})
"""https://docs.ros.org/en/noetic/api/catkin/html/user_guide/ and https://colcon.readthedocs.io/en/released/reference/,
both 2026-11-27."""
_NO_BUILD = pattern(r"catkin\s+(?:init|config)\b|colcon\s+(?!build\b)")
_CONFIG = pattern(r"catkin\s+config\s(?!(?:.*\s)?--profile\b)")
"""What catkin_tools keeps for the builds that follow, unless it is for a profile of a name.

https://catkin-tools.readthedocs.io/en/latest/verbs/catkin_config.html, 2026-11-28.
"""
_NAMED = (["catkin", "build"], ["catkin", "b"])


def of_part(text: str) -> bool:
    """Tell whether a call of a build tool builds only some packages of the workspace."""
    words = text.replace(" -D ", " -D").split()
    limited = (word for word in words if ONLY.fullmatch(word) and not word.endswith("="))
    named = words[:2] in _NAMED and any(not word.startswith("-") for word in words[2:3])
    return named or any(limited) or any(word.partition("=")[0] in _PART for word in words)


def builds(evidence: Evidence, build_tool: BuildTool) -> tuple[Mention, ...]:
    """Return the calls of a build tool that build, of the first page at the root that has one, in its order."""
    calls = [call for call in _calls(evidence, build_tool) if not _NO_BUILD.match(call.text)]
    return tuple(call for call in calls if call.file == calls[0].file)


def by_script(evidence: Evidence, build_tool: BuildTool) -> tuple[Mention, ...]:
    """Return the builds of the only script at the root that calls the build tool: readers of the pages run it."""
    said = [m for m in evidence.mentions if m.topic == "build_tool" and m.source == "script" and "/" not in m.file]
    calls = [call for call in said if call.value == build_tool and not _NO_BUILD.match(call.text)]
    return tuple(calls) if len({call.file for call in calls}) == 1 else ()


def configured(evidence: Evidence, build_tool: BuildTool) -> tuple[Mention, ...]:
    """Return the calls that set options for the builds of that page, before the first of them."""
    first = next(iter(builds(evidence, build_tool)), None)
    calls = (call for call in _calls(evidence, build_tool) if _CONFIG.match(call.text))
    return tuple(call for call in calls if first and call.file == first.file and call.line <= first.line)


def _calls(evidence: Evidence, build_tool: BuildTool) -> list[Mention]:
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.source == "readme" and "/" not in m.file)
    return [mention for mention in said if mention.value == build_tool]


def to_whole(calls: Sequence[Mention]) -> Sequence[Mention]:
    """Return the calls up to the first one that builds the whole workspace, or the first alone where none does."""
    return calls[: 1 + next((index for index, call in enumerate(calls) if not of_part(call.text)), 0)]


def ends_whole(calls: Sequence[Mention]) -> bool:
    """Tell whether the last one builds the whole workspace."""
    return any(not of_part(call.text) for call in calls[-1:])
