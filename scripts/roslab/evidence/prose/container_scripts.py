"""What an author's script that starts a container shares with it: the screen, and a folder that its user names."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import Literal

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import logical_lines
from roslab.evidence.prose.shells import MAX_SIZE
from roslab.repository.checkout import Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_DEPTH = 3
MAX_FILES = 50
MAX_FUNCTIONS = 200
_RUNS = pattern(r"\b(?:docker|podman)\s+(?:container\s+)?(?:run|create)\b")
_SCREEN = pattern(r"(?:^|[\s\"'(=])(?:(?:-e|--env)[ =]?[\"']?DISPLAY\b|(?:-v|--volume)[ =]?[\"']?/tmp/\.X11-unix\b)")
"""https://docs.docker.com/reference/cli/docker/container/run/ (``--env``, ``--volume``), read 2026-11-27."""
_BUILDS = pattern(r"\b(?:docker|podman)\s+(?:buildx\s+|image\s+)?build\b")
_GIVEN = pattern(
    r"(?:^|[\s\"'(=])(?:-v|--volume)[ =]?[\"']?\$(?:\d|\{\d\})/?[\"']?:(/[\w.-][\w./-]*)"
    r"|--mount[ =][\"']?(?:[^\s,]{0,200},){0,8}(?:source|src)=[\"']?\$(?:\d|\{\d\})[^\s,]{0,200},"
    r"(?:[^\s,]{0,200},){0,8}(?:target|destination|dst)=(/[\w.-][\w./-]*)"
)
"""A folder of the host that is the script's first argument or a later one, and where it lies in the container."""
_FUNCTION = pattern(r"^[ \t]{0,40}(?:function[ \t]+[\w-]+(?:[ \t]*\(\))?|[\w-]+[ \t]*\(\))\s{0,40}\{", re.MULTILINE)
_FUNCTION_ENDS = pattern(r"(?:^|;)[ \t]{0,40}\}", re.MULTILINE)
_FLAG = pattern(
    r"-[diPtq]+|--(?:rm|detach|init|interactive|no-healthcheck|oom-kill-disable|privileged|publish-all|quiet|"
    r"read-only|sig-proxy|tty|disable-content-trust)"
)
"""Options without a value: https://docs.docker.com/reference/cli/docker/container/run/, read 2026-11-27."""
_ATTACHED = pattern(r"-(?![diPtq]*[a-zA-Z]$)[a-zA-Z].*|--[^=]+=.*")
"""Options with their values: ``-eDISPLAY``."""
_COMPUTED = pattern(r"\$\([^)\s]*\s|`")
_IMAGE = pattern(r"[a-z0-9][a-z0-9._/:-]*(?:@sha256:[0-9a-f]+)?")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield where scripts share the screen with a container, and where they mount a folder that they are given.

    ``inside`` is the image of that container, where the script names it and does not build it: ``lab/viewer``.
    """
    scripts = [f for f in repository.suffixed(*SHELL_SCRIPTS) if f.path.count("/") <= MAX_DEPTH]
    for file in nearest(scripts)[:MAX_FILES]:
        text = "" if places.vendored(file.path) or file.size > MAX_SIZE else repository.read(file)
        lines = tuple(logical_lines(text)) if _RUNS.search(text) else ()
        if not any(_RUNS.search(logical) for _, logical in lines):
            continue
        yield from _of(file.path, text, lines)


def _of(path: str, text: str, lines: tuple[tuple[int, str], ...]) -> Iterator[Mention]:
    built = _BUILDS.search(text)
    functions = _functions(text)
    found: dict[tuple[Literal["screen", "mounted"], str, str], tuple[int, str]] = {}
    for line, logical in lines:
        image = "" if built else _image(logical)
        for match in _SCREEN.finditer(logical):
            found.setdefault(("screen", "", image), (line, match[0].strip()))
        for match in _GIVEN.finditer(logical) if not any(line in each for each in functions) else ():
            found.setdefault(("mounted", (match[1] or match[2]).rstrip("/"), image), (line, match[0].strip()))
    for (topic, value, image), (line, said) in found.items():
        yield Mention(topic=topic, value=value or said, source="script", file=path, line=line, text=said, inside=image)


def _functions(text: str) -> list[range]:
    """Return the lines of the functions of a script, whose ``$1`` is none of the script's."""
    found = []
    for match in islice(_FUNCTION.finditer(text), MAX_FUNCTIONS):
        end = _FUNCTION_ENDS.search(text, match.end())
        last = end.start() if end else len(text)
        found.append(range(text.count("\n", 0, match.start()) + 1, text.count("\n", 0, last) + 2))
    return found


def _image(logical: str) -> str:
    """Return the image that a line starts a container from, ``""`` where it does not name one as it is."""
    started = _RUNS.search(logical)
    words = iter(logical[started.end() :].split() if started and not _COMPUTED.search(logical) else ())
    for word in words:
        if not word.startswith("-"):
            plain = word.strip("\"'")
            return plain if _IMAGE.fullmatch(plain) else ""
        if not (_FLAG.fullmatch(word) or _ATTACHED.fullmatch(word)):
            value = next(words, "")
            while value[:1] in {"'", '"'} and value.count(value[0]) % 2:
                following = next(words, None)
                if following is None:
                    return ""
                value += following
    return ""
