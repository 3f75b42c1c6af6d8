"""A folder that Python's tools can install."""

from __future__ import annotations

from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class PythonProject:
    """A folder that Python's tools can install: setup.py, setup.cfg or pyproject.toml."""

    file: str
    line: int
    folder: str
    name: str | None
    installable: bool
    """False for a pyproject.toml that only configures tools, and for a setup.py of catkin or ament."""
    requires_python: str | None
    build_requires: tuple[Requirement, ...]
    requirements: tuple[Requirement, ...]
    scripts: tuple[tuple[str, int], ...] = ()
    """Console scripts, with their lines."""
    modules: tuple[str, ...] = ()
    """The modules that those of a setup.py start, by their whole names."""
    version: str | None = None
    script_files: tuple[str, ...] = ()
    """Files of the tree that are installed as programs, each under its own name."""
    more_programs: bool = False
    """Its setup.py may install others than these: it computes some, or has files for ``lib``."""
    extensions: tuple[str, ...] = ()
    """What it compiles: ``c``, ``cuda``, ``cython``, ``cmake``; ``not editable``, ``by install``: by its own command of
    that name alone, and ``gpu``: it stops without one."""
    classifiers: tuple[str, ...] = ()
    setup_imports: tuple[str, ...] = ()
    """Modules that its setup.py imports; ``.`` for the package that it installs."""
    groups: tuple[Requirement, ...] = ()
    """What uv installs with it by default, which pip does not."""
    version_by: tuple[str, ...] = ()
    """What gives it its version from git by the tables of its pyproject.toml, as ``version_tools`` calls it."""
    stopped: str = ""
    """Why its setup.py cannot be installed."""

    @property
    def meant(self) -> bool:
        """It was made to be installed, whether it still can be or not."""
        return self.installable or bool(self.stopped)

    @property
    def refused(self) -> bool:
        """Its backend finds no module to install, its setup.py stops, or it is a Pipfile."""
        refused = bool(self.name) and not self.installable and self.file.endswith("pyproject.toml")
        return refused or bool(self.stopped) or self.file.endswith("Pipfile")
