"""Launch files that a page starts and that the tree has under no such name."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_NAME = pattern(r"([\w-]+)((?:\.launch)?\.(?:launch|py|xml|ya?ml))")
_STARTS = {"roslaunch": 1, "ros2": 2}
"""Where the package follows."""
_ENDINGS = (
    *(".launch", ".launch.py", ".launch.xml", ".launch.yaml", ".launch.yml", ".py", ".xml"),
    *(".launch.in", ".launch.py.in", ".launch.xml.in", ".launch.xacro"),
)


def absent_launch(mention: Mention, repository: Repository) -> Iterator[Mention]:
    """Yield the package and the name of such a file; one with another ending, or that the build fills in, is there."""
    words = mention.value.split()
    at = _STARTS.get(words[0], 0)
    if not at or len(words) < at + 2 or (words[0] == "ros2" and words[1] != "launch"):
        return
    package, name = words[at : at + 2]
    found = _NAME.fullmatch(name)
    if found is None or not re.fullmatch(r"\w+", package) or ".launch" not in name:
        return
    if not launch_there(name, repository):
        yield replace(mention, topic="unlaunched", value=f"{words[0]} {package} {name}", files=())


def launch_there(name: str, repository: Repository) -> bool:
    """Tell whether the tree has a launch file of that name, with another ending, or one that the build fills in."""
    found = _NAME.fullmatch(name)
    return bool(found and repository.named(*(f"{found[1]}{ending}" for ending in (*_ENDINGS, found[2]))))
