"""The one reader of a checkout: lists once, reads lazily, caps sizes, never leaves the tree, runs nothing from it."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

from roslab.errors import ConfigurationError, NothingToBuildError, Problem
from roslab.repository import listing
from roslab.repository.listing import File, Listing, list_tree
from roslab.repository.reading import decoded, read_up_to
from roslab.repository.told_by_git import ToldByGit
from roslab.values.dataclass import dataclass, field, replace

if TYPE_CHECKING:  # to import it takes as long as twenty modules of ours, and most plans do without
    from pathlib import Path

__all__ = ["MAX_TEXT", "File", "Repository", "printable"]

MAX_TEXT = 2 * 1024 * 1024
"""Most bytes read of one file; a longer one is treated as data."""
MAX_KEPT = 256 * 1024
"""Texts below this many bytes are cached; longer ones are read again."""
MAX_NAMED = 80
"""Characters of a folder's path that a message quotes."""
Made = TypeVar("Made")


@dataclass(frozen=True)
class Repository(ToldByGit):
    """A folder on disk, listed once: its absolute path, without links.

    ``branch`` is given by the caller if ``.git`` does not tell it (a tarball, an action's shallow checkout); ``top`` is
    the checkout that the folder is a part of, whose ``.git`` is then used.
    """

    path: str
    branch_hint: str | None = None
    top: Path | None = None
    _texts: dict[str, str] = field(default_factory=dict, repr=False, compare=False)
    _made: dict[Callable[[Repository], Any], Any] = field(default_factory=dict, repr=False, compare=False)
    told: dict[tuple[Any, ...], Any] = field(default_factory=dict, repr=False, compare=False)

    @classmethod
    def open(cls, path: str | Path, *, branch: str | None = None, top: Path | None = None) -> Repository:
        """Open a folder.

        Raises ``ConfigurationError`` if the path is not a folder or cannot be read, ``NothingToBuildError`` if it is
        empty.
        """
        try:
            if not os.path.isdir(path):  # noqa: PTH112 - `Path` would be slower, here and below
                from roslab.repository.no_folder import no_folder  # noqa: PLC0415 - most paths are of a folder

                raise no_folder(path)
            root = os.path.realpath(path)
            if not os.listdir(root):  # noqa: PTH208
                raise NothingToBuildError(
                    Problem(message=f"{printable(str(path))} is empty", hint="check the repository out first")
                )
        except (OSError, ValueError, RuntimeError) as error:
            why = getattr(error, "strerror", None) or error
            raise ConfigurationError(Problem(message=f"cannot read {printable(str(path))}: {why}")) from None
        return cls(root, branch, top)

    @cached_property
    def root(self) -> Path:
        """The folder."""
        from pathlib import Path  # noqa: PLC0415 - as above

        return Path(self.path)

    @cached_property
    def listing(self) -> Listing:
        """Everything in the tree, sorted by path; folders that cannot be listed are left out and named."""
        return list_tree(self.path)

    def once(self, make: Callable[[Repository], Made]) -> Made:
        """Return what a function makes of this repository, which it makes at the first call."""
        if make not in self._made:
            self._made[make] = make(self)
        made: Made = self._made[make]
        return made

    def leaving_out(self, paths: Collection[str]) -> Repository:
        """Return the same folder without some of its files: no reader sees them."""
        if not paths:
            return self
        other = Repository(self.path, self.branch_hint, self.top, self._texts, told=self.told)
        kept = tuple(file for file in self.listing.files if file.path not in paths)
        other.__dict__["listing"] = replace(self.listing, files=kept)  # fills the cached property
        return other

    @property
    def problems(self) -> tuple[tuple[str, str | None, int | None], ...]:
        """``(message, file, line)``: parts of the tree that are not read, and why; file and line may be ``None``."""
        found: list[tuple[str, str | None, int | None]] = []
        if self.listing.truncated:
            message = f"the tree holds more than {listing.MAX_FILES} files: the rest was not read"
            found.append((message, None, None))
        if folders := self.listing.unreadable:
            what = "a folder" if len(folders) == 1 else "folders"
            message = f"{what} could not be listed, and nothing inside was read: {_first(folders)}"
            found.append((message, None, None))
        if files := self.listing.closed:
            what = "a file" if len(files) == 1 else "files"
            found.append((f"{what} could not be read for want of permission: {_first(files)}", None, None))
        return tuple(found)

    @property
    def files(self) -> tuple[File, ...]:
        """Regular files of the tree, sorted by path."""
        return self.listing.files

    @cached_property
    def by_name(self) -> dict[str, tuple[File, ...]]:
        """Files by their last path part, lower-cased."""
        return self._group(lambda file: file.name.lower())

    @cached_property
    def by_suffix(self) -> dict[str, tuple[File, ...]]:
        """Files by their suffix, lower-cased, with its dot; ``""`` for none."""
        return self._group(lambda file: file.suffix)

    def _group(self, key: Callable[[File], str]) -> dict[str, tuple[File, ...]]:
        groups: dict[str, list[File]] = {}
        for file in self.files:
            groups.setdefault(key(file), []).append(file)
        return {name: tuple(files) for name, files in groups.items()}

    def named(self, *names: str) -> tuple[File, ...]:
        """Return the files whose last path part is one of ``names``, whatever their case."""
        return tuple(file for name in names for file in self.by_name.get(name.lower(), ()))

    def suffixed(self, *suffixes: str) -> tuple[File, ...]:
        """Return the files with one of the suffixes (``.cpp``), whatever their case."""
        return tuple(file for suffix in suffixes for file in self.by_suffix.get(suffix.lower(), ()))

    def has(self, path: str) -> bool:
        """Tell whether a regular file lies at a relative path."""
        return path in self._sizes

    def may_have(self, path: str) -> bool:
        """Tell whether a file or a folder lies at a relative path, or it leads through what no walk looks into."""
        parts = path.split("/")
        unseen = {*self.listing.folder_links, *self.listing.outside, *self.listing.unreadable}
        within = ("/".join(parts[: number + 1]) for number in range(len(parts)))
        through = any(each in unseen for each in within) or not listing.SKIPPED_FOLDERS.isdisjoint(parts)
        return self.has(path) or path in self.folders or through or self.listing.truncated

    def leads_to(self, path: str) -> str:
        """Return where a link that leads out of the tree or nowhere points, as it is written; ``""`` for no link."""
        try:
            found = str((self.root / path).readlink()) if path in self.listing.outside else ""
        except OSError:
            found = ""
        self.told["leads_to", path] = found
        return found

    @cached_property
    def _sizes(self) -> dict[str, int]:
        return {file.path: file.size for file in self.files}

    @cached_property
    def folders(self) -> frozenset[str]:
        """Every folder that holds a file, at any depth; ``""`` is the root."""
        found = {""}
        for file in self.files:
            folder = file.folder
            while folder and folder not in found:
                found.add(folder)
                folder = folder.rpartition("/")[0]
        return frozenset(found)

    def read(self, file: File | str, *, limit: int = MAX_TEXT) -> str:
        """Return a file's text, ``""`` if it is missing, binary, unreadable or outside the tree.

        At most ``limit`` bytes are read, invalid UTF-8 becomes U+FFFD. Texts of ordinary size are kept.
        """
        path = file.path if isinstance(file, File) else file
        if path not in self._sizes:
            return ""
        if path in self._texts:
            return self._texts[path]
        data = self.read_bytes(path, limit=limit)
        text = decoded(data)
        if len(data) < min(limit, MAX_KEPT):  # the whole file was read, so the limit does not matter
            self._texts[path] = text
        return text

    def read_bytes(self, file: File | str, *, limit: int = MAX_TEXT) -> bytes:
        """Return at most ``limit`` bytes of a file, ``b""`` where it is missing or outside the tree."""
        path = file.path if isinstance(file, File) else file
        size = self._sizes.get(path, 0)
        if not size:
            return b""
        try:
            # O_NOFOLLOW guards the last part; the listing never descended through a link.
            # O_NONBLOCK: never wait for the other end of a pipe.
            descriptor = os.open(
                f"{self.path}/{path}",
                os.O_RDONLY | os.O_NONBLOCK | (0 if path in self.listing.links else os.O_NOFOLLOW),
            )
            try:
                # Not the whole limit: allocating such a buffer for ten thousand files takes a second
                return read_up_to(descriptor, min(limit, size))
            finally:
                os.close(descriptor)
        except (OSError, ValueError):
            return b""


def nearest(files: Iterable[File]) -> list[File]:
    """Return files sorted by how deep they lie, then by path."""
    return sorted(files, key=lambda file: (file.path.count("/"), file.path))


def _first(paths: tuple[str, ...]) -> str:
    more = f" and {len(paths) - 3} more" if len(paths) > 3 else ""
    return ", ".join(map(_short, paths[:3])) + more


def _short(path: str) -> str:
    named = printable(path) or "the root"
    return named if len(named) <= MAX_NAMED else f"{named[: MAX_NAMED - 1]}…"


def printable(text: str) -> str:
    """Return text that can be printed on one line: control characters and stray bytes escaped."""
    return "".join(
        c if c.isprintable() and not "\ud800" <= c <= "\udfff" else c.encode("unicode_escape", "surrogatepass").decode()
        for c in text
    )
