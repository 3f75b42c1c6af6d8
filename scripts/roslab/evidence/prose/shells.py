"""Scripts that open a shell in which a person goes on: they start no program of the tree."""

from __future__ import annotations

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_SHELL = r"[\"']?(?:\$\{?SHELL\}?|(?:/(?:usr/)?bin/)?(?:ba|z)sh)[\"']?"
_OPENS = pattern(
    rf"^[ \t]*(?:exec[ \t]+)?{_SHELL}[ \t]+(?:-\w[ \t]+){{0,3}}--(?:rcfile|init-file)\b|"
    rf"^[ \t]*(?:exec[ \t]+{_SHELL}|(?:exec[ \t]+)?{_SHELL}[ \t]+-i)[ \t]*$"
)
"""A shell with a file of its own to begin with, as a robot's ``baxter.sh`` opens it, or one that waits for a person."""


def opens_a_shell(mention: Mention, repository: Repository) -> bool:
    """Tell whether a command runs a shell script of the tree that ends in a shell."""
    scripts = [file for file in mention.files if file.endswith(".sh")]
    return any(map(_opens, (repository.read(script, limit=MAX_SIZE) for script in scripts[:1])))


def _opens(text: str) -> bool:
    return any(_OPENS.match(line) for line in text.splitlines())
