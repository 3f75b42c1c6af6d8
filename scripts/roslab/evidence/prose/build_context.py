"""The build context that a Dockerfile's COPY lines fit."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Sequence

from roslab.evidence.prose.installed_context import context_of
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_DOCKER_FOLDER = pattern(
    r"^(?:.*/)?\.?(?:docker\w*|container\w*|devcontainer|build\w*|images?|env\w*|recipes?|"
    r"images?/\w+)(?:/[^/]+)*$|^$",
    re.IGNORECASE,
)
"""Folders that only hold Dockerfiles, whose build context is the root."""
_REPOSITORY_FILES = (".py", ".cpp", "CMakeLists.txt", "package.xml")


def build_context(
    repository: Repository, file: File, copied: list[tuple[str, int]], installed: Sequence[str] = ()
) -> tuple[bool, str | None, str | None]:
    """Return whether the Dockerfile copies the repository's source, its context, and which copied file is missing.

    The context is the folder that contains everything it copies: the root, the folder above, or the Dockerfile's own.
    Where it copies a folder as a whole, that is the one with what it gives pip of its copy (``installed``).
    """
    if not copied:
        return False, None, None
    everything = any(source in {"", "*"} for source, _ in copied)
    named = [(source, line) for source, line in copied if source and not re.search(r"[*?\[]", source)]
    own = file.folder
    order = ["", own.rpartition("/")[0], own] if _DOCKER_FOLDER.search(own) or named else [own, ""]

    def lies(context: str, source: str) -> bool:
        where = posixpath.normpath(f"{context}/{source}".strip("/"))
        return repository.has(where) or where in repository.folders

    fitting = [context for context in dict.fromkeys(order) if all(lies(context, source) for source, _ in named)]
    if not fitting:
        best = min(dict.fromkeys(order), key=lambda context: sum(not lies(context, source) for source, _ in named))
        source, line = next((source, line) for source, line in named if not lies(best, source))
        return everything, best, f"line {line} copies {source}, which the repository does not hold"
    context = fitting[0]
    if "" in (source for source, _ in copied) and (of_pip := context_of(repository, own, installed)) is not None:
        context = of_pip if all(lies(of_pip, source) for source, _ in named) else context
    held = (f"{context}/{source}".strip("/") for source, _ in named)
    return everything or any(w in repository.folders and _holds_source(repository, w) for w in held), context, None


def _holds_source(repository: Repository, folder: str) -> bool:
    prefix = folder + "/"
    return any(file.path.startswith(prefix) and file.name.endswith(_REPOSITORY_FILES) for file in repository.files)
