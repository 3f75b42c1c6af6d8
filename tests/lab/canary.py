"""Search whatever a run leaves for values that must be nowhere, in any form that a program may give them."""

from __future__ import annotations

import bz2
import io
import lzma
import re
import secrets
import tarfile
import zipfile
import zlib
from base64 import b64encode, urlsafe_b64encode
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from urllib.parse import quote

DEPTH = 5
"""Of archives in archives: a record holds a layout that holds a compressed log."""
BEGINNING = 7
"""Bytes with which a form begins; many forms share them, so that one pass tells whether any can be there."""
Place = tuple[str, bytes]
"""Where something was found, in words, and what lies there."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Finding:
    """A value that is somewhere: ``form`` is plain, base64 or percent."""

    canary: str
    form: str
    place: str


def value() -> str:
    """Return a new random value whose three forms all differ."""
    return f"canary+{secrets.token_hex(8)}/{secrets.token_hex(8)}%=="


def forms(text: str) -> Mapping[str, frozenset[bytes]]:
    """Return the byte strings that show a value: as it is, in base64 anywhere in a longer text, percent-encoded."""
    data = text.encode()
    coded = set()
    for before in range(3):
        # What stands before and after shares its first and last letters with the value: only those between are its own
        first, last = -(-before * 8 // 6), (before + len(data)) * 8 // 6
        for encode in (b64encode, urlsafe_b64encode):
            coded.add(encode(b"\0" * before + data)[first:last])
    percent = quote(text, safe="")
    return {
        "plain": frozenset({data}),
        "base64": frozenset(coded),
        "percent": frozenset(form.encode() for form in (percent, quote(text), _lower(percent))) - {data},
    }


def find(places: Iterable[Place], canaries: Mapping[str, str]) -> list[Finding]:
    """Return every value of ``canaries``, by its name, that is in any of the places or in an archive there."""
    wanted = [
        (name, form, needle)
        for name, text in canaries.items()
        for form, needles in forms(text).items()
        for needle in needles
    ]
    beginnings = re.compile(b"|".join(sorted({re.escape(needle[:BEGINNING]) for _, _, needle in wanted})))
    found: dict[Finding, None] = {}
    for outer, content in places:
        for place, data in unpacked(outer, content):
            for name, form, needle in wanted if beginnings.search(data) else ():
                if needle in data:
                    found[Finding(canary=name, form=form, place=place)] = None
    return list(found)


def unpacked(place: str, data: bytes, depth: int = DEPTH) -> Iterator[Place]:
    """Yield what lies in an archive, names and contents, or the data itself where it is none.

    Raises ValueError for a compression that cannot be searched: silence would look like cleanness.
    """
    if data[:4] == b"\x28\xb5\x2f\xfd":
        raise ValueError(f"{place}: zstd cannot be searched")
    if depth and (plain := _decompressed(data)) is not None:
        yield from unpacked(place, plain, depth - 1)
        return
    yield place, data
    if depth and data[257:262] == b"ustar":
        yield from _tar(place, data, depth)
    elif depth and data[:4] == b"PK\x03\x04":
        yield from _zip(place, data, depth)


def _tar(place: str, data: bytes, depth: int) -> Iterator[Place]:
    """Yield what is packed once more in a tar; its own names and contents stand in it as they are."""
    with tarfile.open(fileobj=io.BytesIO(data), mode="r:") as archive:
        for member in archive:
            inner = data[member.offset_data : member.offset_data + member.size] if member.isfile() else b""
            if _packed(inner):
                yield from unpacked(f"{place}: {member.name}", inner, depth - 1)


def _zip(place: str, data: bytes, depth: int) -> Iterator[Place]:
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        for entry in archive.infolist():
            yield from unpacked(f"{place}: {entry.filename}", archive.read(entry), depth - 1)


def _packed(data: bytes) -> bool:
    return data[:2] in {b"\x1f\x8b", b"BZ", b"PK"} or data[:6] == b"\xfd7zXZ\0" or data[257:262] == b"ustar"


def _decompressed(data: bytes) -> bytes | None:
    """Return what was compressed, ``None`` for anything else, such as a file that only begins like an archive."""
    try:
        if data[:2] == b"\x1f\x8b":
            return zlib.decompress(data, wbits=31)
        if data[:3] == b"BZh":
            return bz2.decompress(data)
        if data[:6] == b"\xfd7zXZ\0":
            return lzma.decompress(data)
    except (zlib.error, OSError, ValueError, lzma.LZMAError):
        return None
    return None


def _lower(percent: str) -> str:
    """Return an encoding with its hexadecimal digits in lower case, as some programs write them."""
    parts = percent.split("%")
    return "%".join([parts[0], *(part[:2].lower() + part[2:] for part in parts[1:])])
