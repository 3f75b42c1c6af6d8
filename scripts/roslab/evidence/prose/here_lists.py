"""Lists that a shell gives to an installer by a here-document, a here-string or ``echo``, as the words of its command.

``xargs apt-get install <<EOF``, ``pip install -r /dev/stdin <<< "numpy"``, ``cat > requirements.txt <<EOF``.
https://www.gnu.org/software/bash/manual/html_node/Redirections.html, read 2026-11-28
"""

from __future__ import annotations

import re
import shlex

from roslab.values.pattern import pattern

MOST_LINES = 300
"""Most lines of one list."""
_OPENS = pattern(r"(?<!<)<<-?[ \t]*([\"']?)(\w+)\1(?!<)")
_STRING = pattern(r"<<<[ \t]*(?:\"([^\"\n]*)\"|'([^'\n]*)'|([\w.+=~-]+))")
_ECHO = pattern(
    r"\becho[ \t]+(?:-[en][ \t]+)?(?:\"([^\"\n$`]*)\"|'([^'\n]*)'|([\w.+=~ -]{1,2000}?))[ \t]{0,9}\|[ \t]*"
    r"(?=(?:sudo[ \t]+)?xargs\b)"
)
_XARGS = pattern(r"\bxargs[ \t]+(?:-(?:[rt0]|[nLPd][ \t]*\S+|-no-run-if-empty)[ \t]+)*(?![-\n])")
_FROM_INPUT = pattern(r"[ \t](?:-r[ \t]*|--requirement[= \t]+)(?:/dev/stdin|-)(?=\s|$)")
_INSTALLS = pattern(r"\b(?:apt|apt-get|aptitude|pip[23]?|conda|mamba)\b[^\n|]*\binstall\b")
_CAT = pattern(r"\b(?:cat|tee)[ \t]*$")
_TO_FILE = pattern(
    r"^(\s*)(?:sudo[ \t]+)?(?:cat[ \t]*>[ \t]*|tee[ \t]+)([\w./-]+\.txt)[ \t]*(?:>[ \t]*/dev/null)?[ \t]*$"
)
_BEHIND = pattern(r"[ \t]*>[ \t]*([\w./-]+\.txt)[ \t]*$")
_IN_COMMAND = pattern(r"\$\([ \t]*cat[ \t]*$")
_REMARK = pattern(r"(?:^|[ \t])#.*$")


def spelled_out(text: str) -> str:
    """Return a text with such lists as words of the commands that read them; every line keeps its number."""
    if "<<" not in text and "xargs" not in text:
        return text
    text = _ECHO.sub(lambda match: _given(match) + " \x04", text) if "xargs" in text else text
    lines = [_of_echo(line) if "\x04" in line else line for line in text.split("\n")]
    index = 0
    while index < len(lines):
        if match := _STRING.search(lines[index]):
            lines[index] = _of_string(lines[index], match)
        elif match := _OPENS.search(lines[index]):
            index = _of_document(lines, index, match)
        index += 1
    return "\n".join(lines)


def _given(match: re.Match[str]) -> str:
    return next(group for group in match.groups() if group is not None)


def _of_echo(line: str) -> str:
    """Return ``echo LIST | xargs COMMAND`` as that command; the mark stands behind the list."""
    words, _, command = line.partition("\x04")
    called = _command(command, "")
    return f"{called} {words.strip()}" if called else f"echo {words}| {command}"


def _of_string(line: str, match: re.Match[str]) -> str:
    called = _command(line[: match.start()], line[match.end() :])
    return f"{called} {' '.join(_words(_given(match), called))}" if called else line


def _of_document(lines: list[str], index: int, match: re.Match[str]) -> int:
    """Write the words of a here-document behind its command, and return the index of its last line."""
    end = next((n for n in range(index + 1, min(len(lines), index + MOST_LINES)) if lines[n].strip() == match[2]), None)
    if end is None:
        return index
    before, after = lines[index][: match.start()], lines[index][match.end() :]
    called = _command(before, after)
    if inside := _IN_COMMAND.search(before):
        called = before[: inside.start()] if lines[end + 1 : end + 2] and lines[end + 1].strip() == ")" else ""
        lines[end + 1] = "" if called else lines[end + 1]
    elif not called and (written := _file(before, after)):
        called = _of_file(lines, end, *written)
    if called:
        lines[index] = called
        for number in range(index + 1, end):
            lines[number - 1] += " \\"
            lines[number] = " ".join(_words(lines[number], called))
        lines[end] = ""
    return end


def _command(before: str, after: str) -> str:
    """Return the command that installs what it reads, without what has it read; ``""`` for all others."""
    piped = after.strip()
    if piped.startswith("|") and _CAT.search(before):
        before, piped = _CAT.sub("", before) + piped[1:].strip(), ""
    if piped or not _INSTALLS.search(before):
        return ""
    if _XARGS.search(before):
        return _XARGS.sub("", before, count=1).rstrip()
    return _FROM_INPUT.sub("", before).rstrip() if _FROM_INPUT.search(before) else ""


def _file(before: str, after: str) -> tuple[str, str] | None:
    """Return the indentation and the name of the list that a here-document is written to."""
    if (match := _TO_FILE.match(before)) and not after.strip():
        return match[1], match[2]
    behind = _BEHIND.match(after)
    return (before[: len(before) - len(before.lstrip())], behind[1]) if behind and _CAT.search(before) else None


def _of_file(lines: list[str], end: int, indent: str, name: str) -> str:
    """Return pip's command where a later line installs the list, which then no longer names it."""
    asks = re.compile(rf"[ \t](?:-r[ \t]*|--requirement[= \t]+)(?:\./)?{re.escape(name)}(?=\s|$)")
    found = [n for n in range(end + 1, len(lines)) if "install" in lines[n] and asks.search(lines[n])]
    for number in found:
        lines[number] = asks.sub("", lines[number])
    return f"{indent}pip install" if found else ""


def _words(line: str, called: str) -> list[str]:
    """Return the words of a line of the list: a requirement of pip is one, whatever stands in it."""
    line = _REMARK.sub("", line).strip()
    if not re.search(r"\bpip[23]?\b", called):
        return line.split()
    words = line.split() if re.fullmatch(r"[\w.\[\],=<>!~+ -]+", line) and ";" not in line else [line]
    joined = [line] if re.search(r"[=<>!~] | [=<>!~]", line) else words
    return [word if word.startswith("-") else shlex.quote(word) for word in joined if word]
