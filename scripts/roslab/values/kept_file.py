"""What the program makes of its own files, kept in one file of ``__pycache__`` for as long as each is as it was.

As Python keeps its compiled modules: what is made of a file that has another date or size is made anew, of another
release of Python nothing is taken, and where nothing can be written, nothing is kept.
"""

from __future__ import annotations

import atexit
import marshal
import mmap
import os
import sys
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from importlib.machinery import ModuleSpec

Stamp = tuple[int, int]
"""When a file was changed last, in nanoseconds, and its size."""
Made = tuple[str, Stamp, str, "bytes | memoryview"]
"""The path of the file that something is made of, that file's stamp, a note, and what is made of it."""
_LENGTH = 8
"""Bytes at the beginning, which tell the length of the table that follows; after it comes what is kept."""


DAMAGED = (EOFError, ValueError, TypeError)
"""What ``marshal`` raises for content that was cut off or overwritten; it is made anew then."""


class KeptFile:
    """A file with what was kept, read at once, to which more is added when the program ends."""

    def __init__(self, module: ModuleSpec | None, suffix: str) -> None:
        """Read the file of a module, beside its compiled one; where it has none, nothing is kept.

        What was kept by another version of that module, or of this one, counts for nothing.
        """
        self.file = module and module.cached and f"{module.cached.removesuffix('.pyc')}.{suffix}"
        self._release = (sys.version, stamp(__file__), stamp((module and module.origin) or ""))
        self._rows: dict[str, tuple[str, Stamp, str, int, int]] = {}  # in place of the bytes where they begin and end
        self._later: dict[str, Callable[[], Made | None]] = {}
        with suppress(OSError, *DAMAGED):  # none yet, or one that is damaged
            with open(self.file or "", "rb") as stream:  # noqa: PTH123 - `Path` would be slower
                self._whole = mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ)
            self._start = _LENGTH + int.from_bytes(self._whole[:_LENGTH], "little")
            release, length, rows = marshal.loads(self._whole[_LENGTH : self._start])  # noqa: S302 - as Python's own
            if release == self._release and self._start + length == len(self._whole):
                self._rows = rows

    def find(self, name: str) -> Made | None:
        """Return what was kept under a name, if the file that it was made of is as it was."""
        row = self._rows.get(name)
        if row is None or stamp(row[0]) != row[1]:
            return None
        path, stamped, note, start, end = row
        return path, stamped, note, memoryview(self._whole)[self._start + start : self._start + end]

    def add(self, name: str, make: Callable[[], Made | None]) -> None:
        """Keep under a name what is made when the program ends, if it is."""
        if not self._later:
            atexit.register(self.write)
        self._later[name] = make

    def value(self, path: str, make: Callable[[str], Any]) -> Any:
        """Return what a function of the module makes of a file, of values that ``marshal`` knows, or what was kept."""
        name = f"{make.__name__} {path}"
        if found := self.find(name):
            with suppress(*DAMAGED):
                return marshal.loads(found[3])  # noqa: S302 - as above
        before = stamp(path)
        value = make(path)
        if before:
            self.add(name, lambda: (path, before, "", marshal.dumps(value)))
        return value

    def write(self) -> None:
        """Write what was kept and is still true, and what came to it; of two programs at once, the later one wins."""
        if not self.file or sys.dont_write_bytecode:
            return
        own = f"{self.file}.{os.getpid()}-{os.urandom(4).hex()}"  # in two containers both may be process 1
        try:
            with open(own, "wb") as stream:  # noqa: PTH123
                stream.writelines(self._parts())
            os.replace(own, self.file)  # noqa: PTH105
        except OSError:  # the folder cannot be written, or the disk is full
            with suppress(OSError):
                os.unlink(own)  # noqa: PTH108

    def _parts(self) -> list[bytes | memoryview]:
        """Return what the file consists of."""
        kept = {name: self.find(name) for name in self._rows} | {name: make() for name, make in self._later.items()}
        rows: dict[str, tuple[str, Stamp, str, int, int]] = {}
        parts: list[bytes | memoryview] = []
        end = 0
        for name, made in kept.items():
            if made:
                path, stamped, note, content = made
                rows[name] = (path, stamped, note, end, end + len(content))
                parts.append(content)
                end += len(content)
        table = marshal.dumps((self._release, end, rows))
        return [len(table).to_bytes(_LENGTH, "little"), table, *parts]


def stamp(path: str) -> Stamp | None:
    """Return the date and the size of a file, ``None`` if there is none."""
    try:
        found = os.stat(path)  # noqa: PTH116 - `Path` would be slower
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size
