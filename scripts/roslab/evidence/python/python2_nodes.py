"""Nodes of ROS whose first line starts Python 2 by its number: ``#!/usr/bin/env python2.7``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_PYTHON2 = pattern(r"\A#![ \t]*/usr/(?:bin/env[ \t]+|(?:local/)?bin/)(python2(?:\.7)?)[ \t]*\r?\n")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first of them."""
    for module in modules(repository):
        if module.names_ros and not places.aside(module.file.path) and (match := _PYTHON2.match(module.text)):
            file = module.file.path
            yield Mention(topic="python2_node", value=match[1], source="code", file=file, line=1, text=match[1])
            return
