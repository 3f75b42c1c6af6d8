"""What one Makefile tells, or a script that compiles in its place."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Makefile:
    """A Makefile that compiles C or C++, of a tree without CMake, or a script of the shell that a page runs for it."""

    file: str
    line: int
    programs: tuple[str, ...]
    """The names that its programs may have."""
    linked: tuple[str, ...]
    """The libraries that it links: ``fftw3`` of ``-lfftw3``."""
    cuda: bool
    """It calls CUDA's compiler."""
    modules: tuple[str, ...] = ()
    """What it asks pkg-config for."""
    script: str | None = None
    """How a script is called; ``None`` for a Makefile."""
    called_in: str | None = None
    """The folder in which a page calls it, ``None`` for its own."""
    target: str = ""
    """The target that a page names, else those that link where the first is an object file; ``""`` for the first."""
    parts: tuple[str, ...] = ()
    """The folders below in which it calls make."""
    only: str | None = None
    """The one program that it makes, by its path from there, where it names no other."""
    alone: bool = False
    """All that it calls is compilers and what any system has: no other Makefile, no script and no build tool."""
    stale: bool = False
    """The tree holds a file of the name of one of its programs: make would take it for done."""
    qt: tuple[str, ...] = ()
    """The modules of Qt that a project of qmake asks for, as it calls them."""
    configured: str = ""
    """What writes the Makefile of a project of Autotools, which installs what it makes."""
    installs: tuple[str, ...] = ()
    """The programs that are installed then, by their names."""
    tools: tuple[str, ...] = ()
    """The packages with the programs that this calls."""

    @property
    def by(self) -> str:
        """What the Makefile is written by, ``""`` for an author."""
        return "qmake" if self.qt else "Autotools" if self.configured else ""

    @property
    def folder(self) -> str:
        """The folder in which it is run, ``""`` for the root."""
        return self.file.rpartition("/")[0] if self.called_in is None else self.called_in
