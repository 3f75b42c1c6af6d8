"""System packages that words of roslab.yaml stand for."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Config
from roslab.knowledge.on_request import packages as on_request


def requested(config: Config, ubuntu: str | None) -> Iterator[str]:
    """Yield the packages that ``base.opengl`` and ``matlab`` stand for on this Ubuntu."""
    keys = ["opengl-runtime"] if config.base.opengl else []
    keys += ["opengl-devel"] if config.base.opengl == "devel" else []
    keys += ["matlab"] if config.matlab else []
    for key in keys:
        yield from on_request(key, ubuntu)
