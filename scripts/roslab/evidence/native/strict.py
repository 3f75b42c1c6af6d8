"""Whether a warning of the compiler counts as an error: the image's may warn of more than the author's did."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.native.cpu import build_files
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_STRICT = pattern(
    r"^[^#\n]*?((?<![\w-])-Werror\b|\b(?:CMAKE_)?COMPILE_WARNING_AS_ERROR[ \t]+(?:ON|TRUE|1|YES)\b)",
    re.MULTILINE | re.IGNORECASE,
)
"""https://gcc.gnu.org/onlinedocs/gcc/Warning-Options.html (-Werror) and
https://cmake.org/cmake/help/latest/prop_tgt/COMPILE_WARNING_AS_ERROR.html, 2026-11-28."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first place where a build file has warnings count as errors."""
    for file in repository.once(build_files):
        text = repository.read(file)
        if ("error" in text or "ERROR" in text) and (match := _STRICT.search(text)):
            line = text.count("\n", 0, match.start(1)) + 1
            words = text[match.start() : match.end()].strip()
            yield Mention(topic="strict", value=match[1], source="script", file=file.path, line=line, text=words)
            return
