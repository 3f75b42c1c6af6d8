"""Whether a section of a page is about starting what the repository has, by its titles."""

from __future__ import annotations

import re

from roslab.evidence.prose.headings import WITHOUT
from roslab.values.pattern import pattern

_USAGE = pattern(
    r"^\W*(?:\d[\d.]*\W*)?(?:use\b|using\W*$|using (?:it|this|our|the (?:code|package|software|library|tools?))\b)|"
    r"\bto use\b|\buse$|"
    r"\b(?:run(?:ning)?|usage|launch(?:ing)?|start(?:ing|ed)?|demos?|examples?|quick\w*|play|simulat\w*|execut\w*|"
    r"try|tutorials?|how to|hello)\b|"
    r"运行(?!环境|要求|依赖)|启动|快速|演示|仿真|使用(?:方法|说明)",
    re.IGNORECASE,
)
"""A section that says how to start it, in English or Chinese; ``Using a GPU`` is about one way of several."""
_ASIDE = pattern(
    r"\b(?:real|hardware|calibrat\w*|evaluat\w*|trouble\w*|faq|debug\w*|develop\w*|contribut\w*|convert\w*|conversion|"
    r"record(?:s|ing|er)?|tests?|testing|verif(?:y|ying|ication)|validat(?:e|ing|ion)|docker|format\w*|annotat\w*|benchmark\w*|advanced|optional|tools?|"
    r"how to (?:install|build)|visuali[sz]\w*)\b|"
    r"验证|测试|校验|标定|评估|真机|实机|可视化",
    re.IGNORECASE,
)
"""A section about something else than starting it."""
_MAKES_DATA = pattern(
    r"\b(?:pre-?process\w*|prepar\w*[ -](?:the )?data(?:sets?)?|"
    r"data(?:sets?)?[ -](?:set-?up|prepar\w*|process\w*|generat\w*|download\w*|collect\w*|organi[sz]\w*)|"
    r"(?:generat(?:e|ing)|creat(?:e|ing)|transform(?:ing)?)[ ]+"
    r"(?:(?:the|an?|your|own|new|offline|training|expert|raw)[ ]+){0,3}data(?:sets?)?)\b|"
    r"^\W*(?:\d[\d.]*\W*)?data(?:sets?)?\W*$",
    re.IGNORECASE,
)
"""A section that makes what the programs of others read."""
_TROUBLE = pattern(
    r"\btrouble ?-?shoot\w*|\bfaqs?\b|\bgotchas?\b|\bq ?& ?a\b|\bfrequently asked\b|^\W*(?:issues|problems|errors)\W*$|"
    r"\b(?:known|common|possible|frequent)\s+(?:issues?|problems?|errors?|bugs?|pitfalls?)\b",
    re.IGNORECASE,
)
"""A section for those for whom something did not work."""
_SHOWN = pattern(r"\b(?:quick[ -]?start|demos?|demonstrations?)\b", re.IGNORECASE)
_TRIED = pattern(
    r"\b(?:sanity|quick|smoke|simple|first)[ -]+(?:tests?|check)\b|\btest[ -](?:run|drive|it)\b", re.IGNORECASE
)
"""A section that has the reader run it once, to see whether it works."""
_AND_TEST = pattern(r"\b(train\w*)\s*(?:and|&|/|,|\+)\s*(?:tests?|testing|evaluat\w*|validat\w*)\b", re.IGNORECASE)
"""A section that trains first, and then looks at what came of it."""
_TESTED = pattern(r"^\W*(?:\d[\d.]*\W*)?test(?:ing)?\s+(?!(?:cases?|suites?|data\w*|sets?|splits?)\b)\w", re.IGNORECASE)
"""A section that tests something by its name, as pages of Python call the use of what was trained: ``Test SAM-DA``."""
_TEST_SET = pattern(r"\btest[ -]?(?:set|split)s?\b", re.IGNORECASE)
"""The name of data: ``Inference on the test set``."""
_TO_TEST = pattern(r"(?<!\w)(start|run|launch)\b(.{1,80}?)\bto test\b", re.IGNORECASE)
"""What a section starts to see whether it works: ``Start the simulation to test your setup``."""


def about_running(heading: str, *, python: bool = False) -> int:
    """Return 1 for a section about running it, -1 for one about something else, else 0; the innermost title counts.

    -2 for one that makes the data, which comes before anything else can be done with it. A program of ``python`` that
    is tested in a section about starting is used there: what was trained is called so.
    """
    titles = WITHOUT.sub("", heading).split(" / ")
    if python and _TESTED.match(titles[-1]) and about_running(" / ".join(titles[:-1])) > 0:
        return 1
    for title in reversed(titles):
        if _TRIED.search(title):
            return 1
        if _MAKES_DATA.search(title):
            return -2
        if _ASIDE.search(_AND_TEST.sub(r"\1", _TO_TEST.sub(r"\1\2", _TEST_SET.sub("", title)))):
            return -1
        if _USAGE.search(title):
            return 1
    return 0


def shows(heading: str) -> bool:
    """Tell whether a section shows what the repository does: a quick start, a demonstration."""
    title = heading.rpartition(" / ")[2]
    return bool(_SHOWN.search(title)) and about_running(heading) > 0


def about_trouble(heading: str) -> bool:
    """Tell whether a section, or one around it, is for those for whom something did not work."""
    return any(map(_TROUBLE.search, heading.split(" / ")))


def starts(heading: str) -> bool:
    """Tell whether a section's titles speak of starting something, whatever it is about: ``Launching Evaluations``."""
    return bool(_USAGE.search(heading))
