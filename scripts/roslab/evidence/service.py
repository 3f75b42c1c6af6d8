"""A service of Docker Compose that is built from a Dockerfile of the tree."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Service:
    """What Compose builds and how it starts the container."""

    file: str
    line: int
    said: str
    """The page that has Compose start it."""
    command: tuple[str, ...] = ()
    """Takes the place of the Dockerfile's CMD; ``()`` for that."""
    ports: tuple[str, ...] = ()
    volumes: tuple[tuple[str, str, str], ...] = ()
    """Folders of the tree, or beside it, that the container sees: by the path from the root, where, and ``ro``."""
    target: str = ""
    """The stage of the Dockerfile that it builds, ``""`` for the last one."""
    environment: tuple[tuple[str, str], ...] = ()
    """Variables whose value is known: written there, or the default of what the reader may set."""
