"""Nodes of ROS whose first line starts Python 2 by its number: ``#!/usr/bin/env python2.7``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_PYTHON2 = pattern(r"\A#![ \t]*/usr/(?:bin/env[ \t]+|(?:local/)?bin/)(python2(?:\.7)?)[ \t]*\r?\n")
_PYTHON3 = pattern(r"\A#![^\n]{0,200}\bpython3")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first of them; none where another node starts Python 3, which what pip brings may be for."""
    first: Mention | None = None
    for module in modules(repository):
        file, text = module.file.path, module.text
        if not module.names_ros or places.aside(file):
            continue
        if _PYTHON3.match(text):
            return
        if first is None and (match := _PYTHON2.match(text)):
            first = Mention(topic="python2_node", value=match[1], source="code", file=file, line=1, text=match[1])
    if first:
        yield first
