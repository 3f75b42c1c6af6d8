"""What one Makefile tells."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Makefile:
    """A Makefile that compiles C or C++, of a tree without CMake."""

    file: str
    line: int
    programs: tuple[str, ...]
    """The names that its programs may have."""
    linked: tuple[str, ...]
    """The libraries that it links: ``fftw3`` of ``-lfftw3``."""
    cuda: bool
    """It calls CUDA's compiler."""

    @property
    def folder(self) -> str:
        """The folder in which it is run, ``""`` for the root."""
        return self.file.rpartition("/")[0]
