"""Projects that a plain CMake project downloads as the archive of a branch: today's may not compile any more."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.programs import top_of
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, Mention


def head_archives(evidence: Evidence) -> tuple[Mention, ...]:
    """Return those that the build of the project at the top always comes to."""
    top = top_of(evidence)
    found = [mention for mention in evidence.mentions if mention.topic == "head_archive"]
    if top is None or not found:
        return ()
    folder = posixpath.dirname(top.file)
    files = {each.file for each in evidence.cmake if each is top or (each.always and each.top == folder)}
    return tuple(mention for mention in found if mention.file in files)


def told_of_heads(evidence: Evidence, kind: Kind) -> Iterator[Warning_]:
    """Yield a warning for each of them."""
    for mention in head_archives(evidence) if kind == "cpp" else ():
        yield warn(
            f"CMake downloads {mention.value} as {mention.text}, which is another one each time and may not compile "
            "one day: write the archive of a tag or of a commit",
            mention,
        )
