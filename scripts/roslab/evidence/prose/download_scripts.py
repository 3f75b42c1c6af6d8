"""What a shell script of the tree fetches that a page has its reader run: it is read as the page's own lines are."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import commands, logical_lines
from roslab.evidence.prose.downloads import placed
from roslab.evidence.prose.installs import Collector
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS

MAX_SIZE = 16 * 1024
_SHELLS = frozenset({"bash", "sh"})
_SIMPLE = frozenset({"mkdir", "cd", "wget", "curl", "gdown", "unzip", "tar", "rm", "mv", "echo", "set"})
"""What a script may call: one that also branches, loops or starts programs is not understood line by line."""


def fetched_by(mention: Mention, repository: Repository) -> Iterator[Mention]:
    """Yield what a command of a page fetches and unpacks if it is a script of the tree that only does that.

    ``mention``: the command, with the paths of the tree from its root. What is yielded stands at its place, and has the
    script's path as ``inside``.
    """
    words = mention.value.split()
    script = words[1] if words[0] in _SHELLS and len(words) > 1 else words[0]
    if not script.endswith(SHELL_SCRIPTS) or script not in mention.files or not any(_fetches(script, repository)):
        return
    collector = Collector(mention.file, "readme", folder=mention.inside, heading=mention.heading)
    collector.text(repository.read(script, limit=MAX_SIZE))
    for each in collector.mentions:
        if each.topic in {"fetched", "unpacked"} and (there := placed(each, repository)):
            yield replace(there, line=mention.line, inside=script)


def _fetches(script: str, repository: Repository) -> Iterator[bool]:
    """Yield for each command whether it fetches something, nothing for a script that does anything else too."""
    text = repository.read(script, limit=MAX_SIZE)
    called = [
        posixpath.basename(command.words[0])
        for start, logical in logical_lines(text)
        for command in commands(logical, start)
    ]
    if len(text) < MAX_SIZE and {*called} <= _SIMPLE:
        yield from (name in {"wget", "curl"} for name in called)
