"""Calls of ``just`` on pages, with the lines of the recipe in their place: the image then needs no just."""

from __future__ import annotations

import re
import shlex

from roslab.evidence.lex.justfile import Justfile, parsed
from roslab.evidence.prose.headings import MAX_LINE, fence
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

NAMES = ("justfile", "Justfile", ".justfile")
_INDENTED = ("    ", "\t")
"""How a line of code begins without a fence."""
MAX_SIZE = 128 * 1024
MAX_ADDED = 64 * 1024
"""Most characters by which a page grows: the calls after that stay as they are written."""
MOST_CALLS = 500
"""Most different calls of one justfile of which the lines are looked up."""
MOST_FILES = 60
"""Most justfiles, those nearest to the root first."""
_WORDS = r"just[ \t]+([A-Za-z_][\w-]*(?:[ \t]+[^\s#;&|`<>$]+){0,8})"
_LINE = pattern(rf"^([ \t]*(?:[$>%][ \t]+)?){_WORDS}[ \t]*(?:[ \t]#[^\n]*)?()$")
_SPAN = pattern(rf"(?<!`)(`){_WORDS}[ \t]*(`)(?!`)")
_ENTERS = pattern(r"(?:^|[;&|][ \t]*)(?:cd|pushd)\b")


def with_recipes(text: str, repository: Repository, page: File) -> str:
    """Return a page with what a shell runs, on one line, in place of each call whose recipe is plain lines of it.

    The recipes are those of the justfile in the page's folder, else of that at the root.
    """
    if "just " not in text or not (calls := _calls(repository, page)):
        return text
    lines, fenced, left = text.split("\n"), False, MAX_ADDED
    for number, line in enumerate(lines):
        if fence(line):
            fenced = not fenced
        elif "just " in line and len(line) <= MAX_LINE:
            code = fenced or line.startswith(_INDENTED)
            written = (_LINE if code else _SPAN).sub(lambda match: _run(match, calls), line)
            if len(written) - len(line) <= left:
                left -= max(0, len(written) - len(line))
                lines[number] = written
    return "\n".join(lines)


class _Calls:
    """The recipes of one justfile, with what each call of them runs, which is found once for all pages."""

    def __init__(self, found: Justfile) -> None:
        self._found = found
        self._known: dict[str, str | None] = {}

    def line_of(self, call: str) -> str | None:
        """Return the lines of the recipe that is called, joined; ``None`` where they are not known."""
        if call not in self._known:
            if len(self._known) >= MOST_CALLS:
                return None
            self._known[call] = _joined(call, self._found)
        return self._known[call]


def _calls(repository: Repository, page: File) -> _Calls | None:
    by_folder = repository.once(_justfiles)
    return by_folder.get(page.folder) or by_folder.get("")


def _justfiles(repository: Repository) -> dict[str, _Calls]:
    """Return what the justfiles in the folders of a tree define."""
    by_folder = {file.folder: file for file in repository.named(*NAMES)}
    files = nearest(by_folder.values())[:MOST_FILES]
    return {file.folder: _Calls(parsed(repository.read(file, limit=MAX_SIZE))) for file in files}


def _joined(call: str, found: Justfile) -> str | None:
    try:
        name, *given = shlex.split(call)
    except ValueError:
        return None
    lines = found.lines_of(name, given)
    if not lines or any("`" in line for line in lines):
        return None
    whole = ""
    for line in lines:  # just runs each in a shell of its own
        alone = f"({line})" if len(lines) > 1 and _ENTERS.search(line) else line
        whole += ("" if not whole else " " if re.search(r"(?<!&)&$", whole) else " && ") + alone
    return whole


def _run(match: re.Match[str], calls: _Calls) -> str:
    """Return a call with the lines of its recipe; as it is written where they are not known."""
    whole = calls.line_of(match[2])
    return match[0] if whole is None else f"{match[1]}{whole}{match[3]}"
