"""Releases that pixi.lock names: the lines of its default environment for Linux, each with the address of a package.

https://pixi.sh/latest/workspace/lockfile/, read 2026-11-23. It is YAML of megabytes, and these lines are all that is
needed of it.
"""

from __future__ import annotations

from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern
from roslab.values.specifier import specifiers
from roslab.values.version import version_of

MAX_SIZE = 16 * 1024 * 1024
_ENVIRONMENT = ("environments:", "default:", "packages:", "linux-64:")
"""The keys above the lines, each deeper than the one before it."""
_PACKAGE = pattern(r"- conda: \S*/([\w.+-]+)-([^-/\s]+)-[^-/\s]+\.(?:conda|tar\.bz2)$")


def releases(repository: Repository, folder: str) -> dict[str, str]:
    """Return the version of each of conda's packages, by its name; nothing without a lock in this folder."""
    path = f"{folder}/pixi.lock".lstrip("/")
    if not repository.has(path):
        return {}
    found: dict[str, str] = {}
    keys: list[int] = []
    for line in repository.read(path, limit=MAX_SIZE).splitlines():
        said = line.lstrip()
        depth = len(line) - len(said)
        if said.startswith("- "):
            if len(keys) == len(_ENVIRONMENT) and (match := _PACKAGE.match(said)):
                found.setdefault(match[1].lower(), match[2])
            continue
        if len(keys) == len(_ENVIRONMENT) and depth <= keys[-1]:
            break
        while keys and depth <= keys[-1]:
            keys.pop()
        if len(keys) < len(_ENVIRONMENT) and said == _ENVIRONMENT[len(keys)]:
            keys.append(depth)
    return found


def pinned(name: str, said: str, locked: dict[str, str]) -> str:
    """Return conda's line for a package: at the lock's version where the manifest allows it, else as it is ``said``."""
    version = locked.get(name.lower(), "")
    allowed = specifiers(said) if said not in {"", "*"} else None
    fits = said in {"", "*"} or (allowed is not None and version_of(version) is not None and allowed.contains(version))
    if version and fits:
        return f"{name}={version}"
    sign = "=" if said[:1].isdigit() else ""
    return name if said in {"*", ""} else f"{name}{sign}{said}"
