"""``coinbrew fetch|build PROJECT``: what COIN-OR's own script builds, apt has as a package.

https://github.com/coin-or/coinbrew#readme, read 2026-11-27
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.lex.shell import Command
from roslab.values.pattern import pattern

NAME = "coinbrew"
_VERBS = frozenset({"fetch", "build", "install"})
_END = pattern(r"[:@/].*")
"""The branch or release behind a project's name: ``Ipopt:stable/3.13``, ``Ipopt@3.13.4``."""


def packages(command: Command) -> Iterator[tuple[str, int]]:
    """Yield the packages that bring what a call of coinbrew fetches or builds, each with its line."""
    words = command.words
    called = next((at for at, word in enumerate(words[:2]) if word.rpartition("/")[2] == NAME), None)
    if called is None or called + 1 >= len(words) or words[called + 1] not in _VERBS:
        return
    from roslab.knowledge.coinbrew import coinbrew  # noqa: PLC0415 - few pages call it

    for word, line in zip(words[called + 2 :], command.lines[called + 2 :], strict=False):
        if package := coinbrew().get(_END.sub("", word).lower()):
            yield package, line
