"""Learning environments that code makes and that a package has with an extra alone: the games of Atari."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import first_line
from roslab.evidence.python.modules import modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_ATARI = pattern(
    r"^[^#\n]*?(?:NoFrameskip|\w(?:Deterministic|-ram)-v\d|[\"']ALE/[A-Z]\w*-v\d|\bAtariPreprocessing\b|"
    r"\b(?:from|import)[ \t]+[\w.]*\batari_wrappers\b)",
    re.MULTILINE,
)
_PARTS = ("NoFrameskip", "Deterministic-v")
_WORDS = frozenset({"ALE", "AtariPreprocessing", "atari_wrappers", "ram"})
"""Each such line has one of the parts, or one of these as a word of its own: ``Pong-ram-v0``."""


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return the first place that makes a game of Atari, or wraps one; tests do not count."""
    for module in modules(repository):
        file, text = module.file, module.text
        hints = (*_PARTS, *sorted(_WORDS & module.words))
        if places.test(file.path) or not (match := first_line(_ATARI, text, *hints)):
            continue
        line = text.count("\n", 0, match.start()) + 1
        said = match[0].strip()[:60]
        return (Mention(topic="environment", value="atari", source="code", file=file.path, line=line, text=said),)
    return ()
