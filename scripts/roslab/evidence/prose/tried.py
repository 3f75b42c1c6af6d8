"""What the sentence above a block says of its commands: ``test your installation by running:``, or what they lack.

And which of them a block starts in the background, for the one that comes after them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Literal

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, fence
from roslab.evidence.prose.other_terminals import other_terminals
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_SAID = pattern(
    r"\b(?:[Tt]est|[Vv]erify|[Cc]heck|[Tt]ry)\b[^.\n]{0,40}\b(?:install\w*|set-?up|build)\b[^.\n]{0,60}"
    r"\b(?:run|launch|start|execut)\w*\b|"
    r"\b(?:[Tt]est|[Vv]erify|[Cc]heck)\b(?![^.\n]{0,40}\b(?:CUDA|GPUs?|NVIDIA|drivers?|[Dd]ocker|(?:Py)?[Tt]orch|ROS|Python)\b)"
    r"[^.\n]{0,40}\b(?:is|are)\s+(?:available|working|ready|installed)\b[^.\n]{0,20}\bby\s+(?:run|launch|start|execut)\w*\b|"
    r"\b(?:[Rr]un|[Ll]aunch|[Ss]tart|[Tt]ry)(?:ning|ing)?\s+(?:an?|the|our)\s+(?:\w+\s+){0,2}(?:demo\w*|example)\b"
)
_WITHHELD = pattern(
    r"\b(?:not|n't)(?: been)?(?: yet| currently| publicly){0,2} (?:available|released|published|public)\b[^.\n]{0,20}"
    r"(?:\b(?:now|yet|currently|so far|at the moment)\b|[^.\n]{0,40}\bwill be (?:available|released|published))|"
    r"\b(?:not|n't)(?: been)?(?: yet| currently) (?:available|released|published|public)\b",
    re.IGNORECASE,
)
"""What a program needs is not published: ``the data is not available now, it will be released later``."""
_OPTIONAL = pattern(
    r"\*\*\(?(?:recommended|optional)\)?:?\*\*|\((?:recommended|optional)\)|"
    r"^[ \t]*(?:(?:[-*+]|\d{1,2}[.)])\s+)?\W{0,3}(?:recommended|optional(?:ly)?)\b|"
    r"\b(?:convert|re-?organi[sz]|re-?order|pre-?process)\w*\s+(?:[\w-]+\s+){0,3}(?:(?:ros)?bags?|messages|data(?:set)?s?|logs?)\b",
    re.IGNORECASE | re.MULTILINE,
)
"""A step that not everybody takes, or that only makes the data of the next one."""
_LAST = pattern(r"[.!?:]\)?\s+(?=[A-Z])")
"""Between two sentences: the last one is about the block below it."""
_LEFT = pattern(r"(?<![&|<>\\])&[ \t]*(?:#.*)?$", re.MULTILINE)
"""The end of a command that the shell does not wait for."""
_CODE_ALONE = pattern(r"\s*(?:[-*+]\s+)?`{1,2}[^`]+`{1,2}\s*")
"""A line, of a list or not, that is code and nothing else."""
_PROGRAM = pattern(r"(?:python[\d.]*|bash|sh|\./\S+)(?:\s|$)")
_MEANT = pattern(r"\bnohup\b|train|(?:^|[\s/])(?:main|run)\.(?:py|sh)\b", re.IGNORECASE)
"""What is meant though it is in the background: it runs for days, or is called so."""
_AFTER = pattern(
    r"(?:^|[/_.-])(?:plot\w*|eval\w*|visuali\w+|clients?|wait\w*|tests?|show\w*|view\w*|send\w*|publish\w*|request\w*)"
    r"(?=[_.-]|$)",
    re.IGNORECASE,
)
"""What a program is called that only looks at another one or asks it: alone it can do nothing."""
_NO_NAME = pattern(r"-|(?:python[\d.]*|bash|sh)$")


def read(repository: Repository, said: Iterable[Mention]) -> tuple[Mention, ...]:
    """Return the commands in blocks of pages below such a sentence: ``tried``, ``withheld`` or ``optional_step``.

    So is what a block starts after others in the background, and so are these; and ``withheld`` what is for a second
    terminal where the page runs nothing in the first.
    """
    commands = [mention for mention in said if mention.topic == "command" and mention.source == "readme"]
    files = {mention.file for mention in commands}
    texts = {page.path: text_of(repository, page) for page in pages(repository) if page.path in files}
    behind = (m for file, text in texts.items() for m in _behind(text, [m for m in commands if m.file == file]))
    below = (*_below("tried", _SAID, commands, texts), *_below("withheld", _WITHHELD, commands, texts))
    below += tuple(_below("optional_step", _OPTIONAL, commands, texts))
    launches = [file.path for file in repository.suffixed(".launch", ".py", ".xml") if "launch" in file.name]
    return (*below, *behind, *other_terminals(commands, texts, launches))


def _behind(text: str, commands: list[Mention]) -> Iterator[Mention]:
    """Yield the programs that a block leaves in the background (``&``) before it starts another one: ``withheld``.

    All calls of the one that it starts then are ``tried``. What is of no use without the others is not the one.
    """
    lines = text.split("\n") if _LEFT.search(text) else []
    left: list[Mention] = []
    for m in sorted(commands, key=lambda each: each.line) if lines else ():
        between = lines[left[-1].line : m.line] if left else []
        if any(fence(each) or _indent(each) < _indent(lines[left[-1].line - 1]) for each in between if each.strip()):
            left = []
        if not _PROGRAM.match(m.text):
            continue
        line = lines[m.line - 1]
        if _LEFT.search(line) and not _MEANT.search(line):
            left.append(m)
            continue
        program = m.value.split()[:2]
        if _AFTER.search(next((word for word in m.value.split() if not _NO_NAME.match(word)), "")):
            left = []
        for each in left:
            yield replace(each, topic="withheld")
        yield from (replace(each, topic="tried") for each in commands if left and each.value.split()[:2] == program)
        left = []


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip())


def _below(
    topic: Literal["tried", "withheld", "optional_step"],
    sentence: re.Pattern[str],
    commands: list[Mention],
    texts: Mapping[str, str],
) -> Iterator[Mention]:
    below = {file: _lines(text, sentence) for file, text in texts.items()}
    for m in commands:
        if m.line in below.get(m.file, ()):
            yield Mention(topic=topic, value=m.value, source="readme", file=m.file, line=m.line, text=m.text)


def _lines(text: str, sentence: re.Pattern[str]) -> frozenset[int]:
    """Return the numbers of the lines in the blocks that such a sentence introduces, and of code alone below it."""
    found: set[int] = set()
    fenced = introduced = False
    for number, line in enumerate(text.split("\n") if sentence.search(text) else (), 1):
        if fence(line):
            fenced = not fenced
            introduced = introduced and fenced
        elif introduced and (fenced or _CODE_ALONE.fullmatch(line[:MAX_LINE])):
            found.add(number)
        elif not fenced and line.strip():
            introduced = len(line) <= MAX_LINE and bool(sentence.search(_LAST.split(line.rstrip())[-1]))
    return frozenset(found)
