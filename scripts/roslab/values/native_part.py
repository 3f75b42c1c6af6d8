"""A library that a package of pip is compiled against and does not bring."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class NativePart:
    """A library that a package of pip is compiled against and does not bring."""

    name: str
    """With its version: ``MuJoCo 2.1.0``."""
    package: str
    """Of pip."""
    folder: str
    """Where the package looks for it, from the home directory."""
    archive: str
    unpacks: str
    """The folder that is in the archive."""
    key: tuple[str, str] | None = None
    """A file that it asks for, from the home directory, and its address."""
    variables: tuple[tuple[str, str], ...] = ()
    """Variables that tell the package a path, each with that path from the home directory."""
    guessed: bool = False
    """Nothing that is declared needs it."""

    @property
    def files(self) -> tuple[str, ...]:
        """Names of the files where they come from."""
        return tuple(url.rpartition("/")[2] for url in (self.archive, *(self.key or ())[1:]))
