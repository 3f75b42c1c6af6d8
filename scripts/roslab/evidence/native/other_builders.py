"""Files of build tools that no step of the image calls, at the root of a repository."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.knowledge.other_builders import other_builders
from roslab.repository.checkout import Repository


def read(repository: Repository) -> Iterator[Mention]:
    """Yield one mention for each tool."""
    told = set[str]()
    for name, tool in other_builders().items():
        if tool not in told and repository.has(name):
            told.add(tool)
            yield Mention(topic="other_builder", value=tool, source="filename", file=name, line=1, text=name)
