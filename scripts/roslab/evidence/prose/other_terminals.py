"""Commands for a second terminal where the page only says in words what runs in the first: they need that one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, lines_of
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_OTHER = pattern(
    r"\b(?:in|from|open(?:ing)?|on)\s+(?:an?other|a (?:second|different|separate)|other|the other)\s+"
    r"(?:(?:new|separate|command|bash)\s+)?(?:terminal|shell|console|tab|window|prompt)s?\b",
    re.IGNORECASE,
)
_STARTS = pattern(
    r"^\W*(?:\d+[.)]\s*)?(?:\*\*)?(?:first(?:ly)?,?\s+|then,?\s+)?(?:run|start|launch|execute)\b"
    r"(?![^.\n]{0,60}\b(?:as follows|docker|container)\b)",
    re.IGNORECASE,
)
_LAUNCH = pattern(
    r"(?<![\w./-])[\w-]*(?:[(<\[{][\w -]{1,40}[)>\]}][\w-]*){0,3}(?:\.launch(?:\.(?:py|xml))?|_launch\.py)(?!\w)"
)
"""The name of a launch file, in which the reader may fill in a part: ``sim_(scenario)_nav.launch``."""
_BLANK = pattern(r"[(<\[{][^)>\]}]*[)>\]}]")
_MOST = 200
_CODE = pattern(r"`[^`]+`|^\s*(?:\$|>|sudo|ros\w+|python[\d.]*|bash|sh|\./\S+|docker)(?:\s|$)")


def other_terminals(
    commands: Iterable[Mention], texts: Mapping[str, str], launch_files: Sequence[str]
) -> Iterator[Mention]:
    """Yield such commands as ``withheld``: their section starts something in a sentence and runs nothing before.

    What it starts is ``pointed`` where it is one of the ``launch_files`` of the tree below the page, by its name, in
    which the reader may have to fill in a part: then the first that fits. ``texts``: the pages', by their files.
    """
    here: dict[str, dict[int, Mention]] = {}
    for mention in commands:
        here.setdefault(mention.file, {})[mention.line] = mention
    for file, text in texts.items() if here else ():
        for line, said in _lines(text, frozenset(here.get(file, ()))) if _OTHER.search(text) else ():
            yield replace(here[file][line], topic="withheld")
            folder = f"{file.rpartition('/')[0]}/".lstrip("/")
            if first := _named(said, [path for path in launch_files if path.startswith(folder)]):
                yield replace(here[file][line], topic="pointed", value=first, text=said[:_MOST])


def _named(said: str, paths: Iterable[str]) -> str:
    """Return the first file, by its path, of the first name in a sentence that any has, ``""`` for none."""
    for written in _LAUNCH.finditer(said):
        parts = _BLANK.split(written[0])
        if any(part.strip("_-.") for part in parts[:-1]) or len(parts) == 1 or parts[-1].startswith(("_", "-")):
            meant = re.compile(r"[\w-]+".join(map(re.escape, parts)))
            if fitting := sorted(path for path in paths if meant.fullmatch(path.rpartition("/")[2])):
                return fitting[0]
    return ""


def _lines(text: str, commands: frozenset[int]) -> Iterator[tuple[int, str]]:
    """Yield the numbers of the lines below such a sentence that are ``commands``, each with the words before."""
    started, shown, other = "", False, False
    for line in lines_of(text):
        words = line.text[:MAX_LINE]
        if line.heading:
            started, shown, other = "", False, False
        elif line.number in commands:
            if other and started and not shown:
                yield line.number, started
            else:
                shown = True
        elif line.fenced or _CODE.search(words):
            shown = shown or not other
        elif words.strip():
            if not other and _OTHER.search(words):
                other = True
            elif not other and (started or _STARTS.search(words)):
                started = f"{started} {words}".strip()
