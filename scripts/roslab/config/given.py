"""What roslab.yaml, inputs and options give; most repositories have none of them, and what reads them takes time."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.config.model import Config
from roslab.values.dataclass import dataclass
from roslab.values.origin import Input, Option


@dataclass(frozen=True, kw_only=True, slots=True)
class Override:
    """One value that an input or an option gives for a key of roslab.yaml."""

    key: str
    """The key in today's format, with dots between nested keys: ``platforms``, ``base.ros``."""
    text: str
    """The value as given; in the value of a list, commas, blanks and line breaks separate the entries."""
    origin: Input | Option


def configure(text: str | None, overrides: Sequence[Override] = (), *, file: str | None = None) -> Config:
    """Return the content of roslab.yaml with the overrides applied; ``text`` is ``None`` if there is no such file.

    Raises ``ConfigurationError`` with every problem of both.
    """
    if text is None and not overrides:
        return Config()
    from roslab.config.overrides import overridden  # noqa: PLC0415 - as the first line says

    return overridden(text, overrides, file=file)


def read(text: str | bytes, *, file: str = "roslab.yaml") -> Config:
    """Return the content of one roslab.yaml; ``file`` is its path relative to the repository, for messages.

    Raises ``ConfigurationError`` with every problem of it.
    """
    from roslab.config import reader  # noqa: PLC0415 - as the first line says

    return reader.read(text, file=file)
