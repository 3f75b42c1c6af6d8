"""Converts BuildKit's rawjson progress, which has one object per line, to the lines of its plain progress.

https://docs.docker.com/reference/cli/docker/buildx/build/#progress
"""

from __future__ import annotations

import base64
import binascii
import json
from collections.abc import Iterator
from typing import Any


def plain(text: str, numbers: dict[str, int]) -> list[str] | None:
    """Return the plain lines for one line of rawjson progress, ``None`` for any other line.

    ``numbers`` maps the digest of each step to its number and is kept between calls.
    """
    record = _record(text) if text[-1:] == "}" else None
    return None if record is None else list(_told(record, numbers))


def _record(text: str) -> dict[str, Any] | None:
    try:
        record = json.loads(text)
    except (ValueError, RecursionError):
        return None
    kinds = ("vertexes", "statuses", "logs", "warnings")
    return record if isinstance(record, dict) and any(isinstance(record.get(kind), list) for kind in kinds) else None


def _told(record: dict[str, Any], numbers: dict[str, int]) -> Iterator[str]:
    for vertex in _objects(record.get("vertexes")):
        number = numbers.setdefault(str(vertex.get("digest", "")), len(numbers) + 1)
        if vertex.get("name"):
            yield f"#{number} {_line(vertex['name'])}"
        if vertex.get("error"):
            yield f"#{number} ERROR: {_line(vertex['error'])}"
        elif vertex.get("completed"):
            yield f"#{number} DONE 0.0s"
    for log in _objects(record.get("logs")):
        number = numbers.setdefault(str(log.get("vertex", "")), len(numbers) + 1)
        for part in _data(log.get("data")).splitlines():
            yield f"#{number} 0.0 {part}"


def _objects(value: object) -> list[dict[str, Any]]:
    return [entry for entry in value if isinstance(entry, dict)] if isinstance(value, list) else []


def _line(value: object) -> str:
    return " ".join(str(value).split("\n"))


def _data(value: object) -> str:
    try:
        return base64.b64decode(str(value or "")).decode("utf-8", errors="replace")
    except (binascii.Error, ValueError):
        return ""
