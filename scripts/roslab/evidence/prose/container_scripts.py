"""What an author's script that starts a container shares with it: the screen, and a folder that its user names."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import logical_lines
from roslab.evidence.prose.shells import MAX_SIZE
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_DEPTH = 3
MAX_FILES = 50
_RUNS = pattern(r"\b(?:docker|podman)\s+(?:container\s+)?(?:run|create)\b")
_SCREEN = pattern(r"(?:^|[\s\"'(=])(?:(?:-e|--env)[ =]?[\"']?DISPLAY\b|(?:-v|--volume)[ =]?[\"']?/tmp/\.X11-unix\b)")
"""https://docs.docker.com/reference/cli/docker/container/run/ (``--env``, ``--volume``), read 2026-11-27."""
_GIVEN = pattern(
    r"(?:^|[\s\"'(=])(?:-v|--volume)[ =]?[\"']?\$(?:\d|\{\d\})/?[\"']?:(/[\w.-][\w./-]*)"
    r"|--mount[ =][\"']?(?:[^\s,]{0,200},){0,8}(?:source|src)=[\"']?\$(?:\d|\{\d\})[^\s,]{0,200},"
    r"(?:[^\s,]{0,200},){0,8}(?:target|destination|dst)=(/[\w.-][\w./-]*)"
)
"""A folder of the host that is the script's first argument or a later one, and where it lies in the container."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield where scripts share the screen with a container, and where they mount a folder that they are given."""
    scripts = [f for f in repository.suffixed(".sh", ".bash") if f.path.count("/") <= MAX_DEPTH]
    for file in sorted(scripts, key=lambda each: (each.path.count("/"), each.path))[:MAX_FILES]:
        text = "" if places.vendored(file.path) or file.size > MAX_SIZE else repository.read(file)
        lines = tuple(logical_lines(text)) if _RUNS.search(text) else ()
        if not any(_RUNS.search(logical) for _, logical in lines):
            continue
        found: dict[tuple[str, str], tuple[int, re.Match[str]]] = {}
        for line, logical in lines:
            for match in _SCREEN.finditer(logical):
                found.setdefault(("screen", ""), (line, match))
            for match in _GIVEN.finditer(logical):
                found.setdefault(("mounted", (match[1] or match[2]).rstrip("/")), (line, match))
        for (topic, value), (line, match) in found.items():
            said = match[0].strip()
            if topic == "screen":
                yield Mention(topic="screen", value=said, source="script", file=file.path, line=line, text=said)
            else:
                yield Mention(topic="mounted", value=value, source="script", file=file.path, line=line, text=said)
