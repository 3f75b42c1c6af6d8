"""Finds roslab.yaml in a checkout, and the files that it names."""

from __future__ import annotations

import posixpath

from roslab.config.model import Config
from roslab.errors import ConfigurationError, Problem, RefusedError
from roslab.repository.checkout import Repository, printable
from roslab.values.dataclass import dataclass
from roslab.values.origin import Origin, Place

NAMES = ("roslab.yaml", "roslab.yml", ".roslab.yaml", "repolab.yaml")
"""Names of a configuration in the root folder; the first that exists counts."""
MAX_BYTES = 1024 * 1024
"""Most bytes of a configuration; the longest of 78 real files has two thousand."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Named:
    """A configuration that the user names instead of the default ones."""

    path: str
    """Relative to the repository."""
    origin: Origin


def find(repository: Repository, named: Named | None = None) -> str | None:
    """Return the configuration's path, relative to the repository, ``None`` if there is none.

    Raises ``ConfigurationError`` if the named one is missing or it may not be read, ``RefusedError`` if it is a link
    out of the repository.
    """
    origin = named.origin if named else None
    for name in (named.path,) if named else NAMES:
        if name in repository.listing.outside:
            message = f"{printable(name)} is {_link(repository, name)}"
            raise RefusedError(Problem(message=message, hint="make it a file of the repository", origin=origin))
        if name in repository.listing.closed:
            hint = f"`chmod u+r {printable(name)}` gives its owner the right"
            message = "it cannot be read for want of permission"
            raise ConfigurationError(Problem(message=message, hint=hint, origin=Place(file=name)))
        if repository.has(name):
            return name
    if named:
        message = f"no file {printable(named.path)} in the repository"
        raise ConfigurationError(Problem(message=message, hint="give a path relative to its root", origin=origin))
    return None


def text(repository: Repository, file: str) -> str:
    """Return a configuration's text. Raises ``ConfigurationError`` if it is too large or not UTF-8."""
    size = next(entry.size for entry in repository.files if entry.path == file)
    if size > MAX_BYTES:
        message = f"{size} bytes, a configuration has at most {MAX_BYTES}"
        raise ConfigurationError(Problem(message=message, origin=Place(file=file)))
    data = repository.read_bytes(file)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise ConfigurationError(
            Problem(message="not UTF-8 text", hint="save the file as UTF-8", origin=Place(file=file, line=line))
        ) from None


def check_paths(config: Config, repository: Repository) -> None:
    """Raise ``ConfigurationError`` with all files and folders that roslab.yaml names and that do not exist."""
    files = [("dockerfile", config.dockerfile or None), ("conda", config.conda)]
    for key, paths in (("requirements", config.requirements), ("vcs", config.vcs)):
        files += [(f"{key}.{index}", path) for index, path in enumerate(paths or ())]
    missing = [(key, path) for key, path in files if path and not repository.has(posixpath.normpath(path))]
    context = posixpath.normpath(config.context or ".")
    if context != "." and context not in repository.folders:
        missing.append(("context", context))
    problems = []
    for key, path in missing:
        outside = path in repository.listing.outside
        what = _link(repository, path) if outside else "not there"
        name = key.partition(".")[0]
        problems.append(
            Problem(
                message=f"{name}: {printable(path)} is {what}",
                hint="give a path relative to the root of the repository",
                origin=config.origin(key) or config.origin(name),
            )
        )
    if problems:
        raise ConfigurationError(*problems)


def _link(repository: Repository, path: str) -> str:
    return f"a link to {printable(repository.leads_to(path))}, which is no file of the repository"
