"""Classes of plugins that a description in the tree declares, under a prefix that need not be a package's name.

https://wiki.ros.org/nodelet, "Porting nodes to nodelets"; https://wiki.ros.org/pluginlib, "The Plugin Description File"
(both 2026-11-27).
"""

from __future__ import annotations

import re
from collections.abc import Collection

from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_FILES = 200
_CLASS = pattern(r"<class\s([^>]{0,2000})>")
_NAME = pattern(r"\b(name|type)\s*=\s*[\"']([\w:/]{1,200})[\"']")
_LOAD = pattern(r"\bload\s+((\w{1,60})/\w{1,100})")


def without_own(text: str, repository: Repository, packages: Collection[str]) -> str:
    """Return a launch file with blanks for the nodelets that the tree declares; places in the text stay the same.

    Not for one under the name of a package of the tree, which is then what the file needs.
    """
    if "load" not in text:
        return text

    def blank(match: re.Match[str]) -> str:
        own = match[2] not in packages and match[1] in repository.once(_classes)
        return " " * len(match[0]) if own else match[0]

    return _LOAD.sub(blank, text)


def _classes(repository: Repository) -> frozenset[str]:
    """Return the names of the declared classes: as they are called, or where they have no name, as their type is."""
    found: set[str] = set()
    for file in nearest(f for f in repository.suffixed(".xml") if f.size <= MAX_SIZE)[:MAX_FILES]:
        text = repository.read(file)
        for match in _CLASS.finditer(without_xml_comments(text)) if "base_class_type" in text else ():
            said = dict(_NAME.findall(match[1]))
            found.add(said.get("name") or said.get("type", "").replace("::", "/"))
    return frozenset(found)
