"""Whether a section of a page is about starting what the repository has, by its titles."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_USAGE = pattern(
    r"^\W*(?:\d[\d.]*\W*)?us(?:e|ing)\b|\bto use\b|\buse$|"
    r"\b(?:run(?:ning)?|usage|launch(?:ing)?|start(?:ing|ed)?|demos?|examples?|quick\w*|play|simulat\w*|execut\w*|"
    r"try|tutorials?|how to|hello)\b",
    re.IGNORECASE,
)
"""A section that says how to start it."""
_ASIDE = pattern(
    r"\b(?:real|hardware|calibrat\w*|evaluat\w*|trouble\w*|faq|debug\w*|develop\w*|contribut\w*|convert\w*|conversion|"
    r"record(?:s|ing|er)?|tests?|testing|docker|format\w*|annotat\w*|benchmark\w*|advanced|optional|tools?|"
    r"how to (?:install|build)|visuali[sz]\w*)\b",
    re.IGNORECASE,
)
"""A section about something else than starting it."""
_TRIED = pattern(
    r"\b(?:sanity|quick|smoke|simple|first)[ -]+(?:tests?|check)\b|\btest[ -](?:run|drive|it)\b", re.IGNORECASE
)
"""A section that has the reader run it once, to see whether it works."""
_TO_TEST = pattern(r"(?<!\w)(start|run|launch)\b(.{1,80}?)\bto test\b", re.IGNORECASE)
"""What a section starts to see whether it works: ``Start the simulation to test your setup``."""


def about_running(heading: str) -> int:
    """Return 1 for a section about running it, -1 for one about something else, else 0; the innermost title counts."""
    for title in reversed(heading.split(" / ")):
        if _TRIED.search(title):
            return 1
        if _ASIDE.search(_TO_TEST.sub(r"\1\2", title)):
            return -1
        if _USAGE.search(title):
            return 1
    return 0


def starts(heading: str) -> bool:
    """Tell whether a section's titles speak of starting something, whatever it is about: ``Launching Evaluations``."""
    return bool(_USAGE.search(heading))
