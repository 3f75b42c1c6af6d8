"""Every way in which roslab stops, with its exit code; one ``except RoslabError`` in ``cli`` catches them all."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar


@dataclass(frozen=True, kw_only=True, slots=True)
class Problem:
    """One thing that is wrong, where it stands, and what to write instead.

    ``line`` and ``column`` count from 1; ``None`` where the whole file or the command line is meant.
    """

    message: str
    hint: str | None = None
    file: str | None = None
    line: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        text = f"{place}: {self.message}" if place else self.message
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
