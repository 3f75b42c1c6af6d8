"""The libraries that a file of ELF needs, without its own name."""

from __future__ import annotations

import struct
from pathlib import Path

from roslab.evidence.native import elf, shared_objects
from roslab.repository.checkout import Repository

STRINGS = b"\0libremote.so.1\0libGLEW.so.2.0\0libc.so.6\0"
SONAME, NEEDED, STRTAB, END = 14, 1, 5, 0


def library(*entries: tuple[int, str], cut: int | None = None) -> bytes:
    """Return a file whose one segment begins at address 0x1000, with these names in its dynamic section."""
    header, segments = 64, 2 * 56
    at = header + segments
    strings = at + 16 * (len(entries) + 2)
    tags = [(tag, STRINGS.index(b"\0" + name.encode() + b"\0") + 1) for tag, name in entries]
    tags += [(STRTAB, 0x1000 + strings), (END, 0)]
    head = b"\x7fELF\x02\x01\x01" + bytes(9) + struct.pack("<HHIQQQIHHH", 3, 0x3E, 1, 0, header, 0, 0, 64, 56, 2)
    head += bytes(header - len(head))
    whole = strings + len(STRINGS)
    head += struct.pack("<IIQQQQQQ", 1, 5, 0, 0x1000, 0x1000, whole, whole, 0x1000)
    head += struct.pack("<IIQQQQQQ", 2, 6, at, 0x1000 + at, 0x1000 + at, 16 * len(tags), 16 * len(tags), 8)
    return (head + b"".join(struct.pack("<QQ", *tag) for tag in tags) + STRINGS)[:cut]


def test_its_own_name_is_none_of_them() -> None:
    data = library((NEEDED, "libGLEW.so.2.0"), (SONAME, "libremote.so.1"), (NEEDED, "libc.so.6"))
    assert elf.needed(data) == ("libGLEW.so.2.0", "libc.so.6")
    assert elf.needed(library((SONAME, "libremote.so.1"))) == ()


def test_where_its_start_does_not_tell() -> None:
    data = library((NEEDED, "libc.so.6"))
    for cut in (3, 40, 100, 180, len(data) - len(STRINGS)):
        assert elf.needed(data[:cut]) is None


def test_no_package_of_its_own_name_is_wanted(tmp_path: Path) -> None:
    (tmp_path / "remote.so").write_bytes(library((SONAME, "libremote.so.1"), (NEEDED, "libGLEW.so.2.0")))
    assert [each.name for each in shared_objects.read(Repository.open(tmp_path))] == ["libglew2.0"]
