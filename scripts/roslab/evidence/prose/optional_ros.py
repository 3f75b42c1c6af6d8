"""Where the page at the root says that only some of its readers need ROS: those with the real robot, say."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, lines_of
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_ROS = r"\bros(?:\s?[12])?(?![\w-])"
_NEEDED = r"(?:required|needed|necessary|used)"
_OPTIONAL = pattern(
    rf"{_ROS}[^.\n]{{0,40}}?\bonly\s{_NEEDED}\s(?:if|for|when|to)\b|"
    rf"{_ROS}(?:\s\w+){{0,2}}\s(?:is|are)\s(?:(?:not|n't)\s{_NEEDED}\s(?:if|for|when|to)|(?:\w+\s)?optional)\b|"
    rf"{_ROS}(?:\s\w+){{0,2}}:?[\s*_]{{0,4}}\(optional\)|"
    rf"\(optional\)[:\s*_]{{1,6}}(?:install\s)?{_ROS}|"
    rf"\b(?:do\s?n[o']t|not)\s(?:need|require)\s(?:to install\s)?{_ROS}[^.\n]{{0,20}}\b(?:if|for|to)\b",
    re.IGNORECASE,
)
"""``ROS (only required if you want to use the real robot)``, ``ROS is optional``."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such line of each page at the root."""
    for page in pages(repository):
        text = text_of(repository, page) if "/" not in page.path else ""
        if not _OPTIONAL.search(text):
            continue
        said = (line for line in lines_of(text) if not line.fenced and _OPTIONAL.search(line.text[:MAX_LINE]))
        for line in [*said][:1]:
            what = line.text.strip()[:160]
            yield Mention(topic="optional_ros", value="", source="readme", file=page.path, line=line.number, text=what)
