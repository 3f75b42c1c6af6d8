"""A Dockerfile split into its instructions.

No library is used: the maintained one (dockerfile-parse) knows neither here-documents nor the line of a word inside a
continuation, and both are needed to tell where a fact comes from.
"""

from __future__ import annotations

import json
import posixpath
import re
from collections.abc import Iterator

from roslab.evidence.lex.shell import logical_lines
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern

_INSTRUCTION = pattern(r"^\s*([A-Za-z]+)\s+(.*)$", re.DOTALL)
_KNOWN = frozenset(
    {
        "ADD", "ARG", "CMD", "COPY", "ENTRYPOINT", "ENV", "EXPOSE", "FROM", "HEALTHCHECK",
        "LABEL", "MAINTAINER", "ONBUILD", "RUN", "SHELL", "STOPSIGNAL", "USER", "VOLUME", "WORKDIR",
    }
)  # fmt: skip
_GAP = pattern(
    rf"(?<!\\)(\\[ \t]*\n)((?:[ \t]*(?:#[^\n]*)?\n)+)(?=[ \t]*[^\s#])(?![ \t]*(?:{'|'.join(sorted(_KNOWN))})\s)"
)
"""A continued line, and empty lines and comments below it: Docker skips both, and only warns of the empty ones."""
FROM = pattern(r"^(?:--\S+\s+)*(\S+)(?:\s+as\s+(\S+))?\s*$", re.IGNORECASE)
"""The text of FROM: the image or stage that a stage starts from, and the name that it gets."""
_OPTIONS = pattern(r"^(?:--\S+\s+)+")
_HEREDOC = pattern(r"<<-?\s*[\"']?(\w+)[\"']?")


@dataclass(frozen=True, slots=True)
class Instruction:
    """One instruction: its name in capitals, the text after it, its line."""

    name: str
    text: str
    line: int
    script: bool = False
    """The text is a here-document, not one line with continuations."""

    @property
    def steps(self) -> str:
        """What RUN has a shell do: the text without the options of RUN itself, as ``--mount=type=cache,target=/c``."""
        return _OPTIONS.sub("", self.text)


def instructions(text: str) -> Iterator[Instruction]:
    """Yield the instructions of a Dockerfile; a line that is no instruction has the name ``""``."""
    heredoc, pending, following = "", Instruction("", "", 0), 0
    body: list[str] = []
    for line, logical in logical_lines(_without_gaps(text)):
        if heredoc:
            if logical.strip() == heredoc:
                yield Instruction(pending.name, "\n".join((pending.text, *body)), pending.line, script=True)
                heredoc, body = "", []
            else:
                body.extend("" for _ in range(line - following))  # comment lines
                body.append(logical)
                following = line + logical.count("\n") + 1
            continue
        if not logical.strip():
            continue
        match = _INSTRUCTION.match(logical)
        name = match[1].upper() if match else ""
        pending = Instruction(name if name in _KNOWN else "", match[2] if match else logical, line)
        start = _HEREDOC.search(pending.text) if name in {"RUN", "COPY"} else None
        if start:
            heredoc, following = start[1], line + 1
            pending = replace(pending, text=pending.text[: start.start()] if name == "RUN" else pending.text)
        else:
            yield pending


def _without_gaps(text: str) -> str:
    """Make a comment of each empty line inside a continued instruction, so that it does not end there.

    It ends where the next line begins another instruction: Docker would join the two, and no author wants that. A text
    with here-documents is left as it is, since in those the shell ends a command at an empty line.
    """
    return text if "<<" in text else _GAP.sub(lambda match: match[1] + "#\n" * match[2].count("\n"), text)


def argv(text: str) -> tuple[str, ...]:
    """Return the words of a CMD or ENTRYPOINT: its JSON list, else bash with its line."""
    text = text.strip()
    if text.startswith("["):
        try:
            value = json.loads(text)
        except ValueError:
            return ()
        return tuple(str(part) for part in value) if isinstance(value, list) else ()
    return ("bash", "-c", text) if text else ()


def sources(body: str) -> list[str]:
    """Return what a COPY or ADD takes from the build context; URLs and unknown values are left out.

    Nothing lies above the context: what is written with ``..`` begins at its root.
    https://docs.docker.com/reference/dockerfile/#copy, read 2026-11-26.
    """
    words = body.replace("\n", " ").split()
    if any(word.startswith("--from") for word in words) or "<<" in body:
        return []
    sources = [word for word in words if not word.startswith("--")][:-1]
    if "[" in body and body[body.index("[") :].strip().endswith("]"):
        sources = list(argv(body[body.index("[") :]))[:-1]
    found = (
        source for source in sources if "://" not in source and "$" not in source and not source.startswith("git@")
    )
    return [posixpath.normpath(f"/{source}").strip("/") for source in found]
