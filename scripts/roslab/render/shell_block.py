"""A code block of a README: whether it is shell code for the image, and which lines are input or output."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.prompt import PROMPT

SHELLS = frozenset({"bash", "sh", "shell", "zsh", "ksh", "shellscript", "commandline", "command", "cmdline"})
SESSIONS = frozenset({"console", "terminal", "session", "shell-session", "shellsession", "bash-session", "sh-session"})
"""Languages of a block that shows both input and output."""
_OWN = {"roslab": "host", "docker_build.sh": "host", "docker_run.sh": "host"}
"""Commands of this project, which build and run the image."""
_LANGUAGE = pattern(r"\{?\s*\.?([\w+#-]+)")
_ROOT = pattern(r"\s*#\s+(?=(\S+))")
_FIRST = pattern(r"(?:^|&&|\|\||;|\|)\s*(?:(?:\w+=\S*|time|exec|nohup|env)\s+)*([^\s;&|]+)(?:\s+(\S+))?")
_PROGRAM = pattern(r"\.{0,2}/\w|\w+=|[\w.-]+/[\w./-]+\.(?:py|sh)$")
_NO_COMMAND = pattern(r"[<>=~]+|v?\d+(?:\.\d+)+|[:=].*|is|are|and|or|version")
"""Second words of a list of requirements (``cmake >= 3.5``) or of prose."""
_OPEN = pattern(r"(?:\\|&&|\|\|?|\{|\(|\b(?:do|then|else))\s*$")
_HEREDOC = pattern(r"<<-?\s*(['\"]?)(\w+)\1")


@dataclass(frozen=True, kw_only=True, slots=True)
class Step:
    """A part of a block: input (without prompts) or output."""

    typed: bool
    text: str


def steps(info: str, content: str) -> tuple[Step, ...]:
    """Return the parts of a block that can run in the image, ``()`` if it is not shell code or not for the image.

    ``info`` is the text after the fence, ``""`` for an indented block. A block in which only output can be recognised,
    or that needs a program of the host, is left in the text.
    """
    match = _LANGUAGE.match(info.strip())
    language = match[1].lower() if match else ""
    if language and language not in SHELLS | SESSIONS:
        return ()
    content = _without_margin(content)
    lines = content.split("\n")
    prompt = PROMPT
    if language in SESSIONS and not any(map(PROMPT.match, lines)):
        prompt = _ROOT
    if any(_prompted(prompt, line) for line in lines):
        found = _transcript(lines, prompt)
    elif language in SHELLS or _all_commands(content):
        found = [Step(typed=True, text=content.strip("\n"))]
    else:
        return ()
    typed = [word for step in found if step.typed for word, _ in first_words(step.text)]
    places = [_commands().get(word.removeprefix("./"), "image") for word in typed]
    return () if not typed or "host" in places or set(places) == {"root"} else tuple(found)


def _without_margin(content: str) -> str:
    """Remove the common indentation and leading tabs: in a notebook's bash a tab would ask for a completion."""
    if "<<-" not in content:  # tabs have a meaning there
        content = re.sub(r"^[ \t]+", lambda match: match[0].expandtabs(4), content, flags=re.MULTILINE)
    return textwrap.dedent(content)


@cache
def _commands() -> dict[str, str]:
    """Return ``{word: where it runs}``, used to recognise shell code in a block without a language."""
    return {row["word"]: row["runs_on"] for row in rows("commands")} | _OWN


def _prompted(prompt: re.Pattern[str], line: str) -> re.Match[str] | None:
    match = prompt.match(line)
    return match if match and (prompt is not _ROOT or match[1] in _commands()) else None


def _transcript(lines: list[str], prompt: re.Pattern[str]) -> list[Step]:
    found: list[tuple[bool, list[str]]] = []

    def add(typed: bool, line: str) -> None:
        if not found or found[-1][0] != typed:
            found.append((typed, []))
        found[-1][1].append(line)

    for index, line in enumerate(lines):
        if match := _prompted(prompt, line):
            add(True, line[match.end() :])
        elif found and found[-1][0] and _unfinished("\n".join(found[-1][1])):
            add(True, line.removeprefix("> "))
        elif not line.strip():
            add(found[-1][0] if found else True, line)
        elif line.lstrip().startswith("#") and _typed_next(lines[index + 1 :], prompt):
            add(True, line)
        else:
            add(False, line)
    texts = [(typed, "\n".join(part).strip("\n")) for typed, part in found]
    return [Step(typed=typed, text=text) for typed, text in texts if text.strip()]


def _typed_next(lines: list[str], prompt: re.Pattern[str]) -> bool:
    following = next((line for line in lines if line.strip() and not line.lstrip().startswith("#")), "")
    return _prompted(prompt, following) is not None


def _unfinished(command: str) -> bool:
    """Return whether a shell would ask for another line."""
    for match in _HEREDOC.finditer(command):
        if match[2] not in (line.strip() for line in command[match.end() :].split("\n")):
            return True
    last = command.rpartition("\n")[2]
    if _OPEN.search(last) and not last.endswith("\\\\"):
        return True
    bare = re.sub(r"\\.|#.*$", "", command, flags=re.MULTILINE)
    bare = re.sub(r"'[^']*'|\"[^\"]*\"", "", bare)
    return "'" in bare or '"' in bare


def first_words(text: str) -> Iterator[tuple[str, str]]:
    """Yield the first and the second word of each command, ``""`` if there is no second."""
    for line in re.sub(r"\\\n\s*", " ", text).split("\n"):
        if not line.lstrip().startswith("#"):
            for match in _FIRST.finditer(line):
                yield match[1], match[2] or ""


def _all_commands(content: str) -> bool:
    found = list(first_words(content))
    return bool(found) and all(
        (word in _commands() or _PROGRAM.match(word)) and not _NO_COMMAND.fullmatch(second) for word, second in found
    )
