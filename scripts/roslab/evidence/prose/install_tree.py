"""Programs of a package that are run by their path in the tree that colcon or catkin installs into."""

from __future__ import annotations

from roslab.evidence.lex.shell import Command
from roslab.values.pattern import pattern

INSTALLED = pattern(r"(?:install|devel)/(?:([\w-]+)/)?lib/([\w-]+)/([\w.+-]+)")
"""The path from the folder of a workspace on: of an isolated install tree, a merged one, or catkin's own."""
_PATH = pattern(rf"(?:\S*/)?({INSTALLED.pattern.rpartition('/')[0]}/)(?:\./)?([\w.+-]+)")


def from_workspace(command: Command) -> Command:
    """Return a command whose program lies in an install tree by its path from the workspace's folder."""
    first = command.words[0]
    match = _PATH.fullmatch(first) if "/lib/" in first else None
    if match is None:
        return command
    return command._replace(words=(f"{match[1]}{match[4]}", *command.words[1:]))


def package_and_program(path: str) -> tuple[str, str] | None:
    """Return the package and the program of such a path, ``None`` if it is none."""
    match = INSTALLED.fullmatch(path)
    return (match[2], match[3]) if match and match[1] in {match[2], None} else None
