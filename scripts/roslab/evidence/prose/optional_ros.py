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
_OTHERWISE = pattern(
    r"\b(?:docker|podman|singularity|apptainer|containers?|(?:our|this|the|provided|prebuilt|ready)\s(?:\w+\s)?image)\b|"
    r"\bsources?\b|\b(?:for|to|when|while|be)\s(?:build|built|compil)\w*(?!\W+(?:\w+\W+){0,2}(?:ros|wrappers?|bridge)\b)|"
    r"\bto\s(?:run|use|start|execute|launch)\s(?:(?:the|this|our|any)\s)?"
    r"(?:code|demos?|examples?|library|nodes?|package|programs?|project|repo(?:sitory)?|scripts?|software)\b",
    re.IGNORECASE,
)
"""It is in an image that the reader takes instead, its packages are, or it is needed by all: to run the code."""
_END = pattern(r"[.!?](?:\s|$)")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such line of each page at the root."""
    for page in pages(repository):
        text = text_of(repository, page) if "/" not in page.path else ""
        if not _OPTIONAL.search(text):
            continue
        lines = [*lines_of(text)]
        after = [*(line.text[:MAX_LINE] for line in lines[1:]), ""]
        for line, following in zip(lines, after, strict=True):
            if not line.fenced and _says(line.text[:MAX_LINE], following):
                what = line.text.strip()[:160]
                at = line.number
                yield Mention(topic="optional_ros", value="", source="readme", file=page.path, line=at, text=what)
                break


def _says(line: str, following: str) -> bool:
    """Tell whether a sentence that begins in a line says so; it may end in the line after it."""
    whole = f"{line} {following}"
    for match in _OPTIONAL.finditer(line):
        begin = max((each.end() for each in _END.finditer(line, 0, match.start())), default=0)
        end = _END.search(whole, match.end())
        if not _OTHERWISE.search(whole[begin : end.start() if end else len(whole)]):
            return True
    return False
