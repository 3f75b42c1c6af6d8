"""The folder in which a program has to be started: its own, where it names others from there for Python's path."""

from __future__ import annotations

import posixpath

from roslab.evidence.lex.lines import matches_at
from roslab.evidence.python.modules import Module
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_ADDED = pattern(r"\bsys\.path\.(?:append|insert)\((?:\d+,[ ]?)?[\"']([\w./-]{1,200})[\"']\)")


def own_folder(repository: Repository, module: Module) -> str:
    """Return the folder of a program that adds one to Python's path which is in the tree from there alone, else ``""``.

    Python takes such a path from where it is started, not from where the program lies
    (https://docs.python.org/3/library/sys.html#sys.path, read 2026-11-23).
    """
    folder = module.file.folder
    if not folder:
        return ""
    for match in matches_at(_ADDED, module.text, "sys.path."):
        here, root = (posixpath.normpath(posixpath.join(base, match[1])) for base in (folder, ""))
        if here in repository.folders and root not in repository.folders:
            return folder
    return ""
