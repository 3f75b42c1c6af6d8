"""Functions of a script that clone what they are given: their calls, written as what git is told."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_FUNCTION = pattern(
    r"^[ \t]*(?:function[ \t]+([A-Za-z][\w-]{0,40})[ \t]*(?:\(\))?|([A-Za-z][\w-]{0,40})[ \t]*\(\))\s{0,9}\{"
    r"((?:[^\n]{0,400}\n){1,60}?)[ \t]*\}",
    re.MULTILINE,
)
_CLONES = pattern(r"\bgit\b[^\n#]{0,80}\bclone\b")
_EVALUATES = pattern(r"\beval[ \t]+[\"']?\$(?:\{?1\b|@)")
_ALIAS = pattern(r"\b(\w+)=[\"']?\$\{?(\d)\b")
_REF = pattern(r"(?:\bcheckout|\s-b|\s--branch)[ =][ \t]*[\"']?\$\{?(\w+)")
_URL = pattern(r"(?:https?|git|ssh)://\S+|git@\S+")
_WORD = pattern(r"\"[^\"\n]*\"|'[^'\n]*'|[^\s;&|#]+")
_END = pattern(r"[;&|#\n]")


def spelled_out(text: str) -> str:
    """Return a script with ``git clone -b REF URL`` in place of the calls of functions of its own that do that.

    Its lines keep their numbers.
    """
    cloners: dict[str, int] = {}
    for match in _FUNCTION.finditer(text):
        body = match[3]
        if _EVALUATES.search(body) or (_CLONES.search(body) and "$" in body):
            cloners[match[1] or match[2]] = _place_of_ref(body)
    if not cloners:
        return text
    names = "|".join(map(re.escape, cloners))
    called = re.compile(rf"^([ \t]*)({names})[ \t]+(?!\(|\{{)([^\n]+)$", re.MULTILINE)

    def told(match: re.Match[str]) -> str:
        return f"{match[1]}{_told(match[0].strip(), match[3], cloners[match[2]])}"

    return called.sub(told, text)


def _place_of_ref(body: str) -> int:
    """Return which argument is the branch or the commit, 0 for none."""
    aliases = {name: int(place) for name, place in _ALIAS.findall(body)}
    found = _REF.search(body)
    if found is None:
        return 0
    return int(found[1]) if found[1].isdigit() else aliases.get(found[1], 0)


def _told(call: str, arguments: str, place: int) -> str:
    """Return what git is told, the call itself where it names no repository."""
    given = _END.split(arguments)[0] if not arguments.startswith(("'", '"')) else arguments
    words = [match[0].strip("\"'") for match in _WORD.finditer(given)]
    if words and words[0].startswith("git clone "):
        return words[0]
    url = next((word for word in words if _URL.fullmatch(word)), None)
    if url is None:
        return call
    ref = words[place - 1] if 0 < place <= len(words) and words[place - 1] != url else ""
    return f"git clone -b {ref} {url}" if ref else f"git clone {url}"
