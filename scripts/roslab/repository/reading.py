"""The bytes and the text of files."""

from __future__ import annotations

import os
from codecs import BOM_UTF8

_MOST_OF_GIT = 65_536
"""Most bytes of a file of git's that are read: HEAD, a branch, the settings."""


def read_up_to(descriptor: int, size: int) -> bytes:
    """Return the first bytes of an open file."""
    parts: list[bytes] = []
    while size > 0 and (part := os.read(descriptor, size)):
        parts.append(part)
        size -= len(part)
    return b"".join(parts)


def decoded(data: bytes) -> str:
    """Return a file's text with the line ends of Unix, ``""`` for what is no text."""
    if b"\0" in data[:8192]:
        if data[:2] in (b"\xff\xfe", b"\xfe\xff"):  # Windows editors write requirements.txt in UTF-16
            return data.decode("utf-16", errors="replace")
        return ""
    text = data.removeprefix(BOM_UTF8).decode(errors="replace")  # "utf-8-sig" does so too, in Python
    return text.replace("\r\n", "\n").replace("\r", "\n") if b"\r" in data else text


def text_of(path: str) -> str:
    """Return the text of a file of git's, ``""`` if it cannot be read; of a large one, its beginning."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK)  # a tree that was unpacked may hold a pipe there
        try:
            return decoded(read_up_to(descriptor, _MOST_OF_GIT))
        finally:
            os.close(descriptor)
    except (OSError, ValueError):
        return ""
