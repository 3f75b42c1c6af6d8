"""What the start of a file of the ELF format tells: the machine that it is for, and the libraries that it needs."""

from __future__ import annotations

import struct
from collections.abc import Iterator

MAGIC, _64_BITS, _LITTLE = b"\x7fELF", 2, 1
_LOADED, _DYNAMIC = 1, 2
_NEEDED, _STRINGS = 1, 5
HEADER = 20
"""Bytes that tell the kind and the machine."""
X86_64, AARCH64 = b"\x3e\x00", b"\xb7\x00"
_PROGRAMS = frozenset({b"\x02\x00", b"\x03\x00"})
"""https://refspecs.linuxfoundation.org/elf/gabi4+/ch4.eheader.html, read 2026-11-27"""
MOST = 1_000
"""Most entries of a table that are read."""


def machine(data: bytes) -> bytes:
    """Return the machine that a file is compiled for, as its header has it; nothing for a file of another format."""
    return data[18:20] if data[:4] == MAGIC else b""


def starts(data: bytes) -> bool:
    """Tell whether a file of this format may be a program: one for its own place, or for any, as libraries are."""
    return data[16:18] in _PROGRAMS


def needed(data: bytes) -> tuple[str, ...] | None:
    """Return the libraries that a file of 64 bits is linked with; ``None`` where its start does not tell.

    https://refspecs.linuxfoundation.org/elf/gabi4+/ch5.dynamic.html, 2026-11-27
    """
    try:
        return _needed(data)
    except (struct.error, StopIteration):
        return None


def _needed(data: bytes) -> tuple[str, ...] | None:
    if data[:4] != MAGIC or data[4] != _64_BITS or data[5] != _LITTLE:
        return None
    (table,) = struct.unpack_from("<Q", data, 32)
    size, number = struct.unpack_from("<HH", data, 54)
    headers = [struct.unpack_from("<IIQQQQ", data, table + at * size) for at in range(min(number, MOST))]
    dynamic = next((header for header in headers if header[0] == _DYNAMIC), None)
    if dynamic is None:
        return None
    entries = tuple(_entries(data, dynamic[2], dynamic[5]))
    address = next(value for tag, value in entries if tag == _STRINGS)
    strings = next(h[2] + address - h[3] for h in headers if h[0] == _LOADED and h[3] <= address < h[3] + h[5])
    names = (data[strings + at : data.find(b"\0", strings + at)] for tag, at in entries if tag == _NEEDED)
    found = tuple(name.decode("ascii", "replace") for name in names)
    return found if all(found) else None  # the strings lie further back than was read


def _entries(data: bytes, start: int, size: int) -> Iterator[tuple[int, int]]:
    for at in range(min(size // 16, MOST)):
        yield struct.unpack_from("<QQ", data, start + at * 16)
