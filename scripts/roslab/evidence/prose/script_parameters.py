"""Parameters by their place (``$1``) that a shell script gives a program as the values of options."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_LOOKS = pattern(r"\$#|\b(?:getopts|shift|case|set|function)\b|\[\s*!?\s*-[zn]\b|\$\{\w+:|\w\s?\(\)")
"""What a script has that may do without them, or that has functions with parameters of their own."""
_NAMED = pattern(r"^[ \t]*(?:export[ \t]+)?(\w+)=(?:[\"']?\$\{?([1-9])\}?[\"']?[ \t]*(?:#.*)?$)?", re.MULTILINE)
"""A variable that is set, and the parameter that it gets."""
_GIVEN = pattern(r"(?<![\w-])--?[A-Za-z][\w-]*(?:=|[ \t]+)[\"']?\$\{?(\w+)\}?")


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each parameter without which an option of a script that a page starts has no value, or an empty one."""
    seen: set[str] = set()
    for mention in mentions:
        script = next((file for file in mention.files if file.endswith(SHELL_SCRIPTS)), "")
        if mention.topic != "command" or mention.source != "readme" or not script or script in seen:
            continue
        seen.add(script)
        for number in _needed(repository.read(script, limit=MAX_SIZE)):
            yield replace(mention, topic="parameter", value=number, text=number, file=script, files=(), inside="")


def _needed(text: str) -> list[str]:
    if "$" not in text or _LOOKS.search(text):
        return []
    named: dict[str, str] = {}
    for match in _NAMED.finditer(text):
        named[match[1]] = "" if match[1] in named else match[2] or ""  # set twice, it may have a value
    code = (line for line in text.split("\n") if not line.lstrip().startswith("#"))
    given = {match[1] for line in code for match in _GIVEN.finditer(line)}
    return sorted({number for name in given if (number := named.get(name, name if name in "123456789" else ""))})
