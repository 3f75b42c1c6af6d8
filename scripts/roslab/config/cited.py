"""What is cited of a configuration in messages, how many of these there are, and what YAML does not allow in it."""

from __future__ import annotations

from roslab.repository.checkout import printable
from roslab.values.pattern import pattern

MAX_PROBLEMS = 50
FORBIDDEN = pattern("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufffe\uffff]")
"""Characters that YAML does not allow: controls, surrogates and noncharacters."""
_PASSWORD = pattern(r"//[^/\s]*@")


def shown(text: str, limit: int = 60) -> str:
    """Return a text in a form suitable for messages: printable, on one line, shortened, without a password."""
    text = _PASSWORD.sub("//…@", text)
    text = text if len(text) <= limit else text[: limit - 1] + "…"
    return printable(text)
