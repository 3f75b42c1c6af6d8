"""The submodules that a .gitmodules names, read as git reads it.

https://git-scm.com/docs/git-config#_syntax and https://git-scm.com/docs/gitmodules, read 2026-11-27.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

FILE = ".gitmodules"
_HEADER = pattern(r"\s*\[\s*([\w.-]+)\s*(?:\"((?:[^\"\\\n]|\\.)*)\"?)?\s*\]?")
_KEY = pattern(r"\s*([A-Za-z][\w-]*)\s*=")
_ESCAPED = {"n": "\n", "t": "\t", "b": "\b"}


@dataclass(frozen=True, kw_only=True, slots=True)
class Module:
    """One entry."""

    name: str
    path: str
    """From the folder of the file, without ``/`` at its ends."""
    url: str = ""
    branch: str = ""
    line: int = 1
    """That of its address, else of its path."""


def entries(text: str) -> tuple[Module, ...]:
    """Return the entries that have a path, in their order; of a key that stands twice, the last counts."""
    found: dict[str, dict[str, tuple[str, int]]] = {}
    name: str | None = None
    for number, written in _lines(text):
        line = written
        if match := _HEADER.match(line):
            name = match[2] or "" if match[1].lower() == "submodule" else None
            line = line[match.end() :]
        key = _KEY.match(line)
        if name is not None and key:
            found.setdefault(name, {})[key[1].lower()] = _value(line[key.end() :]), number
    whole = []
    for each, said in found.items():
        path, url, branch = (said.get(key, ("", 1)) for key in ("path", "url", "branch"))
        if path[0].strip("/"):
            line_of = url[1] if url[0] else path[1]
            whole.append(Module(name=each, path=path[0].strip("/"), url=url[0], branch=branch[0], line=line_of))
    return tuple(whole)


def _lines(text: str) -> Iterator[tuple[int, str]]:
    """Yield each line with its number; one that ends with a backslash goes on."""
    pending, start = "", 1
    for number, line in enumerate(text.split("\n"), 1):
        start = start if pending else number
        whole = pending + line.rstrip("\r")
        if whole.endswith("\\") and not whole.endswith("\\\\"):
            pending = whole[:-1]
            continue
        pending = ""
        yield start, whole
    if pending:
        yield start, pending


def _value(written: str) -> str:
    """Return a value without its marks of quotation and what is a comment outside of them."""
    value, quoted, kept = "", False, 0
    signs = iter(written.strip())
    for sign in signs:
        if sign == "\\":
            escaped = next(signs, "")
            value += _ESCAPED.get(escaped, escaped)
        elif sign == '"':
            quoted = not quoted
        elif sign in "#;" and not quoted:
            break
        else:
            value += sign
            if sign.isspace() and not quoted:
                continue
        kept = len(value)
    return value[:kept]
