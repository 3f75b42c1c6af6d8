"""Calls of ``just`` on pages, with the lines of the recipe in their place: the image then needs no just."""

from __future__ import annotations

import re
import shlex

from roslab.evidence.lex.justfile import Justfile, parsed
from roslab.evidence.prose.headings import MAX_LINE, fence
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

NAMES = ("justfile", "Justfile", ".justfile")
_INDENTED = ("    ", "\t")
"""How a line of code begins without a fence."""
MAX_SIZE = 128 * 1024
_WORDS = r"just[ \t]+([A-Za-z_][\w-]*(?:[ \t]+[^\s#;&|`<>$]+){0,8})"
_LINE = pattern(rf"^([ \t]*(?:[$>%][ \t]+)?){_WORDS}[ \t]*(?:[ \t]#[^\n]*)?()$")
_SPAN = pattern(rf"(?<!`)(`){_WORDS}[ \t]*(`)(?!`)")
_ENTERS = pattern(r"(?:^|[;&|][ \t]*)(?:cd|pushd)\b")


def with_recipes(text: str, repository: Repository, page: File) -> str:
    """Return a page with what a shell runs, on one line, in place of each call whose recipe is plain lines of it.

    The recipes are those of the justfile in the page's folder, else of that at the root.
    """
    if "just " not in text or not (found := _justfile(repository, page)):
        return text
    lines, fenced = text.split("\n"), False
    for number, line in enumerate(lines):
        if fence(line):
            fenced = not fenced
        elif "just " in line and len(line) <= MAX_LINE:
            code = fenced or line.startswith(_INDENTED)
            lines[number] = (_LINE if code else _SPAN).sub(lambda match: _run(match, found), line)
    return "\n".join(lines)


def _justfile(repository: Repository, page: File) -> Justfile | None:
    by_folder = {file.folder: file for file in repository.named(*NAMES)}
    file = by_folder.get(page.folder) or by_folder.get("")
    return parsed(repository.read(file, limit=MAX_SIZE)) if file else None


def _run(match: re.Match[str], found: Justfile) -> str:
    """Return a call with the lines of its recipe, joined; as it is written where they are not known."""
    try:
        name, *given = shlex.split(match[2])
    except ValueError:
        return match[0]
    lines = found.lines_of(name, given)
    if not lines or any("`" in line for line in lines):
        return match[0]
    whole = ""
    for line in lines:  # just runs each in a shell of its own
        alone = f"({line})" if len(lines) > 1 and _ENTERS.search(line) else line
        whole += ("" if not whole else " " if re.search(r"(?<!&)&$", whole) else " && ") + alone
    return f"{match[1]}{whole}{match[3]}"
