"""Programs that a page names with a blank in them: ``python3 <system>_train.py`` is one of the tree, by its pattern."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.lex.lines import lines_with
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_SAID = pattern(r"^(?P<before>[^\n]{0,80}?\bpython[\d.]*[ \t]+)(?P<file>[\w./<> -]{0,200}?\.py)(?![\w.])", re.MULTILINE)
_BLANK = pattern(r"<([A-Za-z][\w -]{0,40})>")
_VALUE = pattern(r"[\"'`\u201c]([\w-]{2,40})[\"'`\u201d]")
SHORTEST = 3
"""Fewest letters beside the blanks by which a file is known; with fewer, the page has to name the values."""

MOST = 20
"""Most names of a page that are looked for."""
MOST_BLANKS = 4
"""Most blanks of a name."""


def with_programs(text: str, repository: Repository, page: File) -> str:
    """Return a page with a file of the tree in the place of each that it names with a blank, if there is such a file.

    The one whose values the page names first, in quotation marks; else the first of its folder, which is the page's own
    or the only one that has such files.
    """
    if ".py" not in text or "<" not in text:
        return text
    found = [match for start in lines_with(text, ".py") if (match := _SAID.match(text, start))]
    found = [match for match in found if 0 < len(_BLANK.findall(match["file"])) <= MOST_BLANKS]
    said = tuple(dict.fromkeys(match["file"] for match in found))[:MOST]
    files = {each: _file(each, text, repository, page) for each in said}
    filled = [(match, files.get(match["file"], "")) for match in found]
    for match, file in reversed(filled):
        if file:
            text = f"{text[: match.start('file')]}{file}{text[match.end('file') :]}"
    return text


def _file(said: str, text: str, repository: Repository, page: File) -> str:
    """Return the file that is meant, from the page's folder, ``""`` if none is."""
    known = len(re.sub(r"[^A-Za-z]", "", _BLANK.sub("", said.removesuffix(".py")))) >= SHORTEST
    named = {match[1]: place for place, match in enumerate(_VALUE.finditer(text))}
    best: dict[str, tuple[tuple[int, ...], str]] = {}
    for file, values in _fitting(said, repository, page):
        if not known and not all(value in named for value in values):
            continue
        rank = tuple(named.get(value, len(named)) for value in values)
        folder = file.rpartition("/")[0]
        best[folder] = min(best.get(folder, (rank, file)), (rank, file))
    own = best.get("") or (next(iter(best.values())) if len(best) == 1 else None)
    return own[1] if own else ""


def _fitting(said: str, repository: Repository, page: File) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield the files that a name with blanks fits, from the page's folder, each with what fills the blanks."""
    names: dict[str, str] = {}
    parts: list[str] = []
    end = 0
    for match in _BLANK.finditer(said):
        parts.append(re.escape(said[end : match.start()].removeprefix("./" if not end else "")))
        group = names.setdefault(match[1], f"blank{len(names)}")
        parts.append(f"(?P={group})" if group in "".join(parts) else f"(?P<{group}>[A-Za-z0-9][\\w-]*?)")
        end = match.end()
    whole = re.compile(rf"(?:[\w./-]+/)?{''.join(parts)}{re.escape(said[end:])}")
    for file in repository.once(_programs):
        below = posixpath.relpath(file, page.folder) if page.folder else file
        fits = whole.fullmatch(below)
        if fits and not below.startswith(".."):
            yield below, fits.groups()


def _programs(repository: Repository) -> tuple[str, ...]:
    return tuple(file.path for file in repository.suffixed(".py") if not places.vendored(file.path))
