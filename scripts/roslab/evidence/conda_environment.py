"""What one conda environment file tells."""

from __future__ import annotations

from roslab.values.conda import CondaPackage
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class CondaEnvironment:
    """A conda environment file."""

    file: str
    line: int
    name: str | None
    python: str | None
    """The Python that it names; ``None`` too where it only bounds it."""
    packages: tuple[CondaPackage, ...]
    requirements: tuple[Requirement, ...]
    """The ``pip:`` part."""
    channels: tuple[str, ...] = ()
    specs: tuple[str, ...] = ()
    """Of a manifest of pixi's, which no other manager reads: conda's packages in conda's notation."""
    exported: bool = False
    """A list that says that conda wrote it, on a Linux."""
    flow: frozenset[str] = frozenset()
    """Its lists that stand in brackets, ``pip: [a, b]``: what changes lines finds none of their items."""
    system: str = ""
    """``Windows`` or ``macOS``, where it was written."""
    on_linux: tuple[str, ...] = ()
    """Of such a file, what of its packages Linux has, without their builds; none if that is all as it stands."""
    tasks: tuple[tuple[str, str, int], ...] = ()
    """Of pixi: name, command, line."""
