"""The folder in which a program has to be started: its own, where it names others, or files, from there."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence.lex.lines import matches_at
from roslab.evidence.python.in_comment import in_comment
from roslab.evidence.python.modules import Module
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_ADDED = pattern(
    r"\bsys\.path\.(?:append|insert)\((?:\d+,[ ]?)?(?:os\.getcwd\(\)[ ]?\+[ ]?(?=[\"']/)|"
    r"os\.path\.join\(os\.getcwd\(\),[ ]?|os\.path\.(?:abspath|realpath)\()?[\"']([\w./-]{1,200})[\"']"
)
"""What is added to Python's path: a word, or one behind the folder in which the program is started."""
_READ = pattern(
    r"(?:(?<![\w])(?:open|load|loads?txt|genfromtxt|read_csv|imread|listdir|glob|load_model|loadURDF|exists|isfile|isdir)"
    r"\(\s{0,40}|\bdefault[ ]?=[ ]?)[\"'](\.\./[\w./-]{1,200})[\"']"
)
"""What is read above the folder in which the program is started."""


def own_folder(repository: Repository, module: Module) -> str:
    """Return the folder of a program that adds one to Python's path which is in the tree from there alone, else ``""``.

    Also of one that reads a file or a folder above, which only from there is in the tree.
    Python takes such a path from where it is started, not from where the program lies
    (https://docs.python.org/3/library/sys.html#sys.path, read 2026-11-23).
    """
    folder = module.file.folder
    if not folder:
        return ""
    for path in _paths(module):
        here, root = (posixpath.normpath(posixpath.join(base, path)) for base in (folder, ""))
        if _there(here, repository) and not _there(root, repository):
            return folder
    return ""


def _paths(module: Module) -> Iterator[str]:
    for match in matches_at(_ADDED, module.text, "sys.path."):
        yield match[1].lstrip("/") if "getcwd" in match[0] else match[1]
    for match in _READ.finditer(module.text) if any(quoted in module.text for quoted in ('"../', "'../")) else ():
        if not in_comment(module.text, match.start()):
            yield match[1]


def _there(path: str, repository: Repository) -> bool:
    """Tell whether a path, from the root, is a folder or a file of the tree; the root itself is one."""
    return path == "." or path in repository.folders or repository.has(path)
