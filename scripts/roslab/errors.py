"""Every way in which roslab stops, with its exit code; one ``except RoslabError`` in ``cli`` catches them all."""

from __future__ import annotations

from typing import ClassVar

from roslab.values.dataclass import dataclass
from roslab.values.origin import Origin


@dataclass(frozen=True, kw_only=True, slots=True)
class Problem:
    """One thing that is wrong, what to write instead, and where it was said; ``None`` where nobody said it."""

    message: str
    hint: str | None = None
    origin: Origin | None = None

    @property
    def file(self) -> str | None:
        """Path of the file that is wrong, ``None`` where it is no file."""
        return self.origin.file if self.origin else None

    @property
    def line(self) -> int | None:
        """Line in that file, from 1."""
        return self.origin.line if self.origin else None

    @property
    def column(self) -> int | None:
        """Column in that line, from 1."""
        return self.origin.column if self.origin else None

    def __str__(self) -> str:
        text = f"{self.origin}: {self.message}" if self.origin else self.message
        return f"{text} ({self.hint})" if self.hint else text


class RoslabError(Exception):
    """Base of everything a user may see; carries one or more problems."""

    exit_code: ClassVar[int] = 1

    def __init__(self, *problems: Problem | str) -> None:
        self.problems = tuple(Problem(message=p) if isinstance(p, str) else p for p in problems)
        super().__init__("\n".join(map(str, self.problems)))


class ConfigurationError(RoslabError):
    """Wrong arguments or a wrong roslab.yaml."""

    exit_code = 2


class NothingToBuildError(RoslabError):
    """The folder holds nothing that roslab recognises."""

    exit_code = 3


class RefusedError(RoslabError):
    """Refused for safety: an author's file would be lost, a link leads out, a stranger would publish."""

    exit_code = 4


class BuildError(RoslabError):
    """The engine, the registry, the build or the image failed."""

    exit_code = 5
