"""Folders of the author's machine that a program of Python puts on its path whatever its arguments are."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.lex.always_run import always_run
from roslab.values.pattern import pattern

_ADDED = pattern(
    r"\bsys\.path\.(?:append\(|insert\([ \t]{0,9}\d{1,3}[ \t]{0,9},)[ \t]{0,9}([^()\n]{1,200}?)[ \t]{0,9}\)"
)
_GIVEN = pattern(r"(?<![\w.])([A-Za-z_]\w{0,60})[ \t]{0,9}=(?!=)[ \t]{0,9}([^\n#]{1,300})")
_ELSEWHERE = pattern(r"[\"'](/(?:home|Users|root|mnt|media)/[^\s\"']+)[\"']")


def read(text: str) -> Iterator[tuple[str, int]]:
    """Yield each such folder with the line that adds it, be it by a name that is never given anything else."""
    for match in _ADDED.finditer(text) if "sys.path." in text else ():
        written = [match[1]]
        if match[1].isidentifier():
            written = [given[2].strip() for given in _GIVEN.finditer(text) if given[1] == match[1]]
        folders = [_ELSEWHERE.fullmatch(each) for each in written]
        last = folders[-1] if folders else None
        if last and all(folders) and always_run(text, match.start()):
            yield last[1], text.count("\n", 0, match.start()) + 1
