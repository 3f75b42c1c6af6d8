"""The distribution whose messages code reads bags with: ``get_typestore(Stores.ROS2_HUMBLE)`` of rosbags."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.in_comment import in_comment
from roslab.evidence.python.modules import modules
from roslab.knowledge.distros import distros
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_WORD = "Stores.ROS"
_STORE = pattern(r"\bStores\.ROS[12]_([A-Z]+)\b")
"""https://ternaris.gitlab.io/rosbags/topics/typesys.html, 2026-11-27"""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each distribution once, at its first place in the code; none of a test or an example."""
    told: set[str] = set()
    for module in modules(repository):
        text, file = module.text, module.file.path
        for match in _STORE.finditer(text) if _WORD in text and not places.aside(file) else ():
            name = match[1].lower()
            if name in distros() and name not in told and not in_comment(text, match.start()):
                told.add(name)
                line = text.count("\n", 0, match.start()) + 1
                yield Mention(topic="typestore", value=name, source="code", file=file, line=line, text=match[0])
