"""What industrial_ci runs around its own steps: ``BEFORE_SCRIPT``, ``AFTER_INIT``, and the scripts that these name.

https://github.com/ros-industrial/industrial_ci/blob/master/doc/index.rst, custom commands, 2026-11-26.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.evidence.lex.yaml import Scalar
from roslab.evidence.prose.installs import Collector
from roslab.evidence.prose.merged import Prose
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
_KEY = pattern(r"(?:BEFORE|AFTER)_[A-Z_]+")
_ASSIGNED = pattern(r"\b(?:BEFORE|AFTER)_[A-Z_]+=(?:\"([^\"\n]*)\"|'([^'\n]*)'|(\S+))")
_SCRIPT = pattern(r"(?<![\w/.-])(?:\./)?([\w./-]+\.(?:sh|bash))\b")


def hooks(repository: Repository, values: Iterable[Scalar], file: str) -> Iterator[Prose]:
    """Yield what the hooks of a CI file install, each script once and as a script of the author's."""
    collector = Collector(file, "ci")
    scripts: dict[str, None] = {}
    for value in values:
        if "BEFORE_" not in value.text and "AFTER_" not in value.text and not _KEY.fullmatch(value.key):
            continue
        assigned = ["".join(group or "" for group in match.groups()) for match in _ASSIGNED.finditer(value.text)]
        for command in assigned:
            collector.logical(command, value.line)
        for command in (*assigned, *((value.text,) if _KEY.fullmatch(value.key) else ())):
            scripts |= dict.fromkeys(posixpath.normpath(path) for path in _SCRIPT.findall(command))
    yield collector.prose()
    for path in scripts:
        if repository.has(path):
            script = Collector(path, "script")
            script.text(repository.read(path, limit=MAX_SIZE))
            yield script.prose()
