"""Lines of requirement files that name the Python which they are for: ``# python3.8``, ``python==3.8.10``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention, RequirementFile
from roslab.evidence.python.requirements import MAX_SIZE
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_INTRODUCED = r"[\w ,:-]{0,60}\b(?:with|on|for|using|use|under|requires?|needs?|recommended|version)[ \t:]{1,3}"
_COMMENT = pattern(
    rf"^[ \t]*#+[ \t]*(?:{_INTRODUCED})?python[ \t]{{0,3}}(?:version[ \t]{{0,3}})?(==?|:)?[ \t]{{0,3}}"
    r"([23]\.\d{1,2})(?:\.(?:\d{1,2}|x|\*))?[ \t]*\.?[ \t]*$",
    re.IGNORECASE | re.MULTILINE,
)
"""A line of its own that ends with the version."""
_PINNED = pattern(
    r"^[ \t]*python[ \t]*={1,3}[ \t]*([23]\.\d{1,2})(?:[.=][\w.*=]*)?[ \t]*$", re.IGNORECASE | re.MULTILINE
)
"""A line of conda's in a list that pip reads, too."""
_LINE = pattern(r"^[ \t]*[^#\s]", re.MULTILINE)


def read(repository: Repository, files: Iterable[RequirementFile]) -> tuple[Mention, ...]:
    """Return what the files at the root or right below it say; nothing where they name several Pythons.

    Only a pin (``# python==3.8``) counts below the first package: a comment may be the title of the lines below it.
    """
    near = (file.file for file in files if file.purpose == "run" and file.file.count("/") <= 1)
    found = [each for path in near for each in _of_file(repository.read(path, limit=MAX_SIZE), path)]
    one = len({mention.value for mention, _ in found}) == 1
    return tuple(mention for mention, counts in found if counts) if one else ()


def _of_file(text: str, path: str) -> Iterator[tuple[Mention, bool]]:
    """Yield what one file says, and whether that is about all of it."""
    first = _LINE.search(text)
    for match in _PINNED.finditer(text) if "ython" in text else ():
        line = text.count("\n", 0, match.start(1)) + 1
        yield (
            Mention(topic="python", value=match[1], source="manifest", file=path, line=line, text=match[0].strip()),
            True,
        )
    for match in _COMMENT.finditer(text) if "ython" in text else ():
        line = text.count("\n", 0, match.start(2)) + 1
        said = Mention(
            topic="python", value=match[2], source="manifest", file=path, line=line, text=match[0].strip()[:200]
        )
        yield said, (match[1] or "").startswith("=") or first is None or match.end() < first.start() + 1
