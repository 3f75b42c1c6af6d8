"""What a Dockerfile gives pip of its copy of the whole build context: it tells which folder the context is."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator, Mapping

from roslab.evidence.prose.installs import Collector
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MANIFESTS = ("pyproject.toml", "setup.py", "setup.cfg")
"""A folder without any of them is nothing that pip installs. https://pip.pypa.io/en/stable/topics/local-project-installs/"""
_BY_PIP = pattern(r"\bpip[\d.]*\b|\bsetup\.py\b")
_ELSEWHERE = pattern(r"\b(?:cd|pushd)\s+[\"']?(?![\w.])")
"""To a folder by an absolute path, or by one that is not known."""
_EXTRAS = pattern(r"\[.*")


def installed(text: str, source: str, workdir: str, known: Mapping[str, str]) -> Iterator[str]:
    """Yield what a step gives pip by a path of the copy, relative to that: ``.`` for the folder itself.

    ``text``: what the shell runs, ``source``: the folder of the copy, ``workdir``: the one in which the step begins.
    """
    if not _BY_PIP.search(text) or _ELSEWHERE.search(text):
        return
    collector = Collector("", "dockerfile", known)
    collector.text(text)
    for asked in collector.requirements:
        if asked.role in {"project", "file"} and "://" not in asked.written:
            path = posixpath.relpath(posixpath.join(workdir, _EXTRAS.sub("", asked.written)), source)
            if "$" not in path and path.partition("/")[0] != "..":
                yield path


def context_of(repository: Repository, folder: str, asked: Iterable[str]) -> str | None:
    """Return the one of the folders above a Dockerfile that has all of this where it is asked for, the outermost first.

    ``None`` where none has: a step may have made it. ``folder``: that of the Dockerfile.
    """
    if not (paths := tuple(asked)):
        return None
    parts = folder.split("/") if folder else []
    above = ("/".join(parts[:end]) for end in range(len(parts) + 1))
    return next((each for each in above if all(_there(repository, each, path) for path in paths)), None)


def _there(repository: Repository, context: str, path: str) -> bool:
    where = posixpath.normpath(posixpath.join(context, path))
    where = "" if where == "." else where
    return repository.has(where) or any(repository.has(f"{where}/{name}".lstrip("/")) for name in MANIFESTS)
