"""What the program found in trees of files, kept for the next time: a file for each tree, beside the compiled modules.

It is read back as Python's own files there are, and only where this user wrote it and nobody else can: what is kept may
be values of any class. A file that was cut off or overwritten counts for nothing, and where nothing can be written,
nothing is kept.
"""

from __future__ import annotations

import os
import stat
import sys
import zlib
from contextlib import suppress
from importlib.machinery import ModuleSpec

MOST_BYTES = 64 * 1024 * 1024
"""Most bytes of all trees together; those that were not used for longest go."""
LARGEST = 16 * 1024 * 1024
"""Most bytes of one tree."""
_SUFFIX = ".tree"
_CHECKED = 4
"""Bytes at the beginning, which are right only where all that follows is."""


_begun = False


def install() -> None:
    """Let trees be kept from here on: the program asks for it as it starts, and nobody else who imports it."""
    global _begun  # noqa: PLW0603 - as Python has one table of modules
    _begun = True


class KeptTree:
    """What is kept of one tree, named by its path."""

    def __init__(self, module: ModuleSpec | None, path: str) -> None:
        """Take the module beside whose compiled file it lies; where that has none, nothing is kept."""
        cached = module.cached if module and _begun else None
        self._beside = cached and cached.removesuffix(".pyc")
        name = zlib.crc32(path.encode(errors="surrogateescape"))
        self._file = f"{self._beside}.{name:08x}{_SUFFIX}"

    def read(self) -> memoryview | None:
        """Return what was kept under this name, maybe of another tree; ``None`` for nothing."""
        if not self._beside:
            return None
        with suppress(OSError):
            descriptor = os.open(self._file, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
            with open(descriptor, "rb") as stream:  # noqa: PTH123
                if not _of_this_user(os.fstat(descriptor)):
                    return None
                whole = memoryview(stream.read(LARGEST + 1))
            if len(whole) > LARGEST or int.from_bytes(whole[:_CHECKED], "little") != zlib.crc32(whole[_CHECKED:]):
                return None
            os.utime(self._file)  # the one used last
            return whole[_CHECKED:]
        return None

    def write(self, content: bytes) -> None:
        """Keep this in the place of what was kept before; of two programs at once, the later one wins."""
        if not self._beside or sys.dont_write_bytecode or _CHECKED + len(content) > LARGEST:
            return
        own = f"{self._file}.{os.getpid()}-{os.urandom(4).hex()}"  # in two containers both may be process 1
        try:
            descriptor = os.open(own, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with open(descriptor, "wb") as stream:  # noqa: PTH123
                stream.writelines((zlib.crc32(content).to_bytes(_CHECKED, "little"), content))
            os.replace(own, self._file)  # noqa: PTH105
            self._leave_room()
        except OSError:  # the folder cannot be written, or the disk is full
            with suppress(OSError):
                os.unlink(own)  # noqa: PTH108

    def _leave_room(self) -> None:
        """Remove the trees that were not used for longest, where all together are too large."""
        folder, _, name = (self._beside or "").rpartition("/")
        with os.scandir(folder) as entries:
            own = [entry for entry in entries if entry.name.startswith(f"{name}.") and _SUFFIX in entry.name]
            trees = [(entry.stat(), entry.path) for entry in own]
        size = sum(status.st_size for status, _ in trees)
        for status, path in sorted(trees, key=lambda tree: tree[0].st_mtime_ns):
            if size <= MOST_BYTES:
                break
            os.unlink(path)  # noqa: PTH108
            size -= status.st_size


def _of_this_user(status: os.stat_result) -> bool:
    """Tell whether a file is this user's, and nobody else may write it."""
    return stat.S_ISREG(status.st_mode) and status.st_uid == os.geteuid() and not status.st_mode & 0o022
