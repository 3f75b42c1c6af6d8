"""Choices that a page leaves to its reader in a command: ``run_[indoor|outdoor].py``, ``a.launch or b.launch``."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_CHOICE = pattern(r"(?<=[\w./-])(?:\[(\w+)(?:\|[\w-]+)+\]|\{(\w+)(?:\|[\w-]+)+\}|<(\w+)(?:\|[\w-]+)+>)(?!\()")
_OFFER = pattern(r"\|(?<=\w\|)[\w-]")
"""What each choice within a word has; it begins with the bar, which is found much faster than the end of a word."""
_START = r"(?:roslaunch|ros2[ \t]{1,4}launch|python[\d.]{0,5})[ \t]{1,4}"
_FILE = r"[\w./-]{1,200}(?:\.launch(?:\.(?:py|xml|ya?ml))?|\.py)(?![\w./-])"
_EITHER = r"(?:[ \t]{1,20}(?:or|/)|,)[ \t]{1,20}(?:or[ \t]{1,20})?"
_OR_ELSE = r",?[ \t]{1,20}(?:or|/)[ \t]{1,20}"
_PACKAGE = r"(?:\w{1,100}[ \t]{1,4})?"
_SEVERAL = pattern(
    rf"(?<![\w`./-])({_START}{_PACKAGE}{_FILE})(?:{_OR_ELSE}{_START}{_PACKAGE}{_FILE}|{_EITHER}(?!{_START}){_PACKAGE}{_FILE})+"
)
"""Launch files or files of Python, of which a command can be given any; whole commands behind a comma all run."""
_OR = pattern(r"(?:launch|py|xml|yaml|yml)(?:[ \t]{1,20}(?:or|/)|,)[ \t]", re.IGNORECASE)


def with_first_choice(text: str) -> str:
    """Take the first of what a page lets its reader choose from: names in a word, files that one command starts."""
    text = _CHOICE.sub(lambda match: match[match.lastindex or 0], text) if _OFFER.search(text) else text
    return _SEVERAL.sub(lambda match: match[1], text) if _OR.search(text) else text
