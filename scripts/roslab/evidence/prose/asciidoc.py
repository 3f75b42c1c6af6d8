"""Pages in AsciiDoc, as Markdown writes the same: titles, blocks of code, lists and links.

https://docs.asciidoctor.org/asciidoc/latest/syntax-quick-reference/ and, for titles that are underlined and paragraphs
that are indented, https://asciidoc-py.github.io/userguide.html (both 2026-11-28)
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from roslab.values.pattern import pattern

_FENCE = "```"
_TITLE = pattern(r"(={1,6})[ \t]{1,9}(\S[^\n]*)")
_UNDER = {"=": 1, "-": 2, "~": 3, "^": 4, "+": 5}
"""The levels of titles by what underlines them."""
_NEAR, _SHORTEST = 1, 3
"""Most letters by which the line below a title is longer or shorter (Asciidoctor, which GitHub shows such pages with:
lib/asciidoctor/parser.rb), and the fewest of it: ``--`` is another thing."""
_BLOCK = pattern(r"(?:-{4,}|\.{4,})[ \t]*")
_COMMENT = pattern(r"/{4,}[ \t]*")
_LANGUAGE = pattern(r"\[(?:source|listing)?(?:%\w+)?[ \t]*,[ \t]*([\w+-]+)(?:[^\]\w+-][^\]]*)?\][ \t]*")
_LEFT = pattern(
    r"//(?!/).*|\+[ \t]*|\[[^\[\]\n]{0,200}\][ \t]*|\[\[[^\]\n]{1,99}\]\][ \t]*|:!?[\w-]{1,60}!?:(?:[ \t].*)?|"
    r"(?:ifn?def|ifeval|endif|include|image|toc|video)::?.*"
)
"""Lines that show nothing: comments, attributes, what joins two blocks, what is included."""
_ATTRIBUTE = pattern(r":([\w-]{1,60}):[ \t]{1,9}(\S.{0,200})")
_NAMED = pattern(r"\{([\w-]{1,60})\}")
_LONGEST = 200
"""Most letters of an attribute's value in which others stand: each may be named many times by the next."""
_NUMBERED = pattern(r"(\.{1,5})[ \t]{1,9}(?=\S)")
_BULLET = pattern(r"(\*{1,5})[ \t]{1,9}(?=\S)")
_BLOCK_TITLE = pattern(r"\.(?=[^\s.])")
_LINK = pattern(r"(?:\blink:|(?=https?://))([^\s\[\]<>|]{1,500})\[([^\]\n]{0,200})\]")
_LITERAL = pattern(r"[ \t]{1,8}(?![*.\-|+] |\d+\. )(?=\S)")
"""What stands before a paragraph that is shown as it is."""


def as_markdown(text: str) -> str:
    """Return a page of AsciiDoc as Markdown; its lines keep their numbers."""
    lines = text.split("\n")
    named: dict[str, str] = {}
    for given in filter(None, map(_ATTRIBUTE.fullmatch, lines)):
        value = _filled(given[2].strip(), named)
        named[given[1]] = value if len(value) <= _LONGEST else given[2].strip()
    said = [""] * len(lines)
    fence, language, literal, hidden = "", "", False, ""
    for number, line in enumerate(lines):
        before = lines[number - 1] if number else ""
        if hidden:
            hidden = "" if line.rstrip() == hidden else hidden
        elif not fence and _COMMENT.fullmatch(line):
            hidden = line.rstrip()
        elif fence:
            said[number] = _FENCE if line.rstrip() == fence else line
            fence = "" if line.rstrip() == fence else fence
        elif level := _under(line, before):
            said[number - 1], said[number] = f"{'#' * level} {before.strip()}", ""
        elif _BLOCK.fullmatch(line) or line.startswith(_FENCE):
            fence = _FENCE if line.startswith(_FENCE) else line.rstrip()
            said[number] = line if fence == _FENCE else f"{_FENCE}{language}"
        elif (literal or not before.strip()) and _LITERAL.match(line):
            literal = True
            said[number] = f"    {line.lstrip()}"
        else:
            said[number] = _written(line, named)
        literal = literal and bool(line.strip())
        match = _LANGUAGE.fullmatch(line)
        language = match[1] if match else language if line.startswith(".") and not _BLOCK.fullmatch(line) else ""
    return "\n".join(said)


def _under(line: str, before: str) -> int:
    """Return the level of the title that a line underlines, 0 for none."""
    short, title = line.rstrip(), before.rstrip()
    same = len(short) >= _SHORTEST and short == short[:1] * len(short) and short[:1] in _UNDER
    near = abs(len(short) - len(title)) <= _NEAR and title[:1].isalnum()
    return _UNDER[short[0]] if same and near else 0


def _written(line: str, named: Mapping[str, str]) -> str:
    line = _filled(line, named)
    if title := _TITLE.fullmatch(line):
        return f"{'#' * len(title[1])} {title[2]}"
    if _LEFT.fullmatch(line):
        return ""
    if item := _NUMBERED.match(line):
        line = f"{'   ' * (len(item[1]) - 1)}1. {line[item.end() :]}"
    elif item := _BULLET.match(line):
        line = f"{'  ' * (len(item[1]) - 1)}* {line[item.end() :]}"
    else:
        line = _BLOCK_TITLE.sub("", line, count=1) if _BLOCK_TITLE.match(line) else line
    return _LINK.sub(_link, line) if "[" in line else line


def _filled(text: str, named: Mapping[str, str]) -> str:
    """Return a text with the values of the attributes that it names."""
    return _NAMED.sub(lambda match: named.get(match[1], match[0]), text) if "{" in text else text


def _link(match: re.Match[str]) -> str:
    return f"[{match[2] or match[1]}]({match[1]})"
