"""TOML by Python's own reader, or by its backport before Python 3.11."""

from __future__ import annotations

import sys
from typing import Any


def parsed(text: str) -> dict[str, Any]:
    """Return a document's tables.

    Raises ``ValueError`` if it is no TOML, or is nested more deeply than Python can follow.
    """
    if sys.version_info >= (3, 11):  # imported here, since most repositories never need it
        import tomllib  # noqa: PLC0415
    else:
        import tomli as tomllib  # noqa: PLC0415
    try:
        return tomllib.loads(text)
    except RecursionError as error:
        raise ValueError("nested too deeply") from error
