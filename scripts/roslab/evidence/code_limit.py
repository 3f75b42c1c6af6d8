"""A sign in the code of what it compiles with."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class CodeLimit:
    """A sign in the code of the versions of a library, or of the compiler, that it compiles with."""

    library: str
    at_least: str | None
    below: str | None
    what: str
    file: str
    line: int
    cuda: bool = False
    """CUDA's compiler alone sees the place."""
