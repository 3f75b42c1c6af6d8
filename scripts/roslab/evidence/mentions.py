"""Names of the world in running text: ROS distros, Ubuntu releases, CUDA and Python versions."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Literal

from roslab.evidence.facts import Mention

MAX_MENTIONS = 120
"""Per file and topic: a changelog names versions without end."""
_DISTROS = "indigo|jade|kinetic|lunar|melodic|noetic|dashing|eloquent|foxy|galactic|humble|iron|jazzy|kilted|lyrical|rolling|crystal|bouncy|ardent"
_AMBIGUOUS = frozenset(
    {
        "iron",
        "rolling",
        "crystal",
        "bouncy",
        "ardent",
        "humble",
        "jade",
        "indigo",
        "lunar",
        "kinetic",
        "galactic",
        "lyrical",
    }
)
_PATTERNS: tuple[tuple[Literal["distro", "ubuntu", "cuda", "cudnn", "python"], re.Pattern[str]], ...] = (
    ("distro", re.compile(rf"(?<![A-Za-z])({_DISTROS})(?![A-Za-z])", re.IGNORECASE)),
    (
        "ubuntu",
        re.compile(
            r"(?<![A-Za-z])(?:ubuntu[\s:_-]*(?:lts\s*)?(1[46]\.04|18\.04|2[0246]\.04)|(trusty|xenial|bionic|focal|jammy|noble|resolute))(?![A-Za-z])",
            re.IGNORECASE,
        ),
    ),
    (
        "cuda",
        re.compile(
            r"(?<![A-Za-z])cuda(?:[\s_-]*toolkit)?(?:\s*\(?\s*(?:version|v|==?|>=|~|:)?\s*|[-=:]+)(\d{1,2}\.\d)(?:\.\d+)*",
            re.IGNORECASE,
        ),
    ),
    ("cuda", re.compile(r"(?<=[+/])cu(\d{2,3})\b")),
    ("cudnn", re.compile(r"(?<![A-Za-z])cudnn(?:[\s:v=_-]|version)*(\d)(?:\.\d+)*", re.IGNORECASE)),
    (
        "python",
        re.compile(
            r"(?<![A-Za-z])python(?:\s*(?:version|>=|==?|~=|:|\()?\s*|[-=])([23]\.\d{1,2})(?:\.\d+|\.x)?(?![\d])",
            re.IGNORECASE,
        ),
    ),
)
_MORE = re.compile(r"(?:[\s,/|&-]*(?:or|and|to)?\s*(?:python)?\s*[23]\.\d{1,2}(?![\d.])){1,6}", re.IGNORECASE)
_CONTEXT = re.compile(r"\bros\b|ros[-_ ]?[12]|distro|ubuntu|branch|catkin|colcon|/opt/ros", re.IGNORECASE)


def read(
    text: str, file: str, source: Literal["recipe", "ci", "readme", "script"], first: int = 1
) -> Iterator[Mention]:
    """Yield the versions that a text names, with the line each stands on; ``first`` is the number of its first line."""
    for topic, pattern in _PATTERNS:
        position, line, found = 0, first, 0
        for match in pattern.finditer(text):
            start = text.rfind("\n", 0, match.start()) + 1
            end = text.find("\n", match.end())
            context = text[
                max(start, match.start() - 90) : min(end if end >= 0 else len(text), match.end() + 90)
            ].strip()
            value = next(group for group in match.groups() if group).lower()
            if topic == "distro" and value in _AMBIGUOUS and not _CONTEXT.search(context):
                continue
            if pattern.pattern.startswith("(?<=[+/])cu"):
                value = f"{value[:-1]}.{value[-1]}"
            line += text.count("\n", position, match.start())
            position = match.start()
            yield Mention(topic=topic, value=value, source=source, file=file, line=line, text=context)
            if topic == "python" and (more := _MORE.match(text, match.end())):  # "Python 3.6, 3.7 or 3.8"
                for further in re.findall(r"\d\.\d{1,2}", more[0]):
                    yield Mention(topic=topic, value=further, source=source, file=file, line=line, text=context)
            found += 1
            if found >= MAX_MENTIONS:
                break
