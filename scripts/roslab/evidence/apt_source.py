"""A package source of apt that a page adds."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class AptSource:
    """A line ``deb URL SUITE COMPONENT…`` of a page, with the key that the page fetches for it."""

    url: str
    """With ``{codename}``, as the suite."""
    suite: str
    """``{codename}`` where the page asks the system for the name of its release."""
    components: tuple[str, ...]
    key: str | None
    """The address of its key, by https; ``None`` where there is none that can be trusted."""
    refused: str | None
    """Why there is no key."""
    file: str
    line: int


def host_of(url: str) -> str | None:
    """Return the host of an address, ``None`` if it has none, or none that can be read (``https://[HOST/``)."""
    from urllib.parse import urlsplit  # noqa: PLC0415 - few trees add a source

    try:
        return urlsplit(url).hostname
    except ValueError:
        return None
