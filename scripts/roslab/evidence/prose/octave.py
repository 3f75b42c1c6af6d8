"""Programs of Octave that a page runs: the files of MATLAB's language that GNU Octave opens.

https://docs.octave.org/latest/Executable-Octave-Programs.html, https://docs.octave.org/latest/Using-Packages.html
(read 2026-11-27).
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import matlab
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.knowledge.octave import OCTAVE, octave_packages
from roslab.repository.checkout import Repository


def file_of(mention: Mention) -> str:
    """Return the file of the tree that a command of a page has Octave run, ``""`` where it is no such command."""
    if mention.topic != "command" or mention.value.partition(" ")[0] not in OCTAVE:
        return ""
    return next((file for file in mention.files if file.endswith(".m")), "")


def asked(mention: Mention, repository: Repository) -> Iterator[Dependency]:
    """Yield Octave for a command of a page that runs a file of the tree by it, and the packages that the tree loads."""
    if not file_of(mention):
        return
    names = ("octave", *(octave_packages()[name] for name in matlab.loaded(repository) if name in octave_packages()))
    for name in names:
        yield Dependency(
            namespace="apt", name=name, strength="used", file=mention.file, line=mention.line, role="octave"
        )
