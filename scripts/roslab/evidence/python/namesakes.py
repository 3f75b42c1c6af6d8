"""Folders of the tree that are called like a known package: for some imports they are the module, for others not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet

from roslab.evidence.on_path import on_path
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import dataclass

_CODE = (".py", ".pyx", ".so")
_PROJECTS = ("setup.py", "pyproject.toml", "setup.cfg", "package.xml")
_BELOW = ("", "/src", "/python", "/lib", "/scripts")
"""Where the packages of a project lie in its folder."""
_OF_BINDINGS = frozenset({"bindings", "binding", "python", "python3", "py", "src", "lib", "wrapper", "wrappers", "api"})


@dataclass(frozen=True, kw_only=True)
class Namesakes:
    """The places in which the tree has modules of known packages' names."""

    found: Mapping[str, frozenset[str]]
    """By name, the folders that hold a file or a folder of that name."""
    roots: frozenset[str]
    """Folders that are on Python's path whoever imports."""
    named: frozenset[str]
    """Names of folders in lines that add to Python's path."""
    repository: Repository

    def foreign(self, module: str, file: File) -> bool:
        """Tell whether a file's import of a module, by its whole name, is of no folder of the tree.

        Python looks into the folder of the program and into those of its path, and nowhere below
        (https://docs.python.org/3/library/sys.html#sys.path, read 2026-11-27). Any folder above the file may be that.
        """
        top, _, inner = module.partition(".")
        if top not in self.found:
            return False
        return not any(self._has(path, inner) for path in self._seen(top, file))

    def without(self, top: str, names: AbstractSet[str], file: File) -> bool:
        """Tell whether a file takes ``names`` of a module, and the tree has nothing of that name but folders without.

        Python prefers an installed package to a folder that is none, whichever comes first on its path
        (https://peps.python.org/pep-0420/#specification, read 2026-11-27).
        """
        seen = self._seen(top, file)
        plain = all(path in self.repository.folders and not self._module(path) for path in seen)
        return bool(names) and plain and not any(self._has(path, name) for path in seen for name in names)

    def _seen(self, top: str, file: File) -> list[str]:
        folders = (folder for folder in self.found[top] if self._on_path(folder, file))
        return [f"{folder}/{top}".lstrip("/") for folder in folders]

    def _module(self, path: str) -> bool:
        """Tell whether a path is that of a module or of a package."""
        return any(self.repository.has(f"{each}{suffix}") for each in (path, f"{path}/__init__") for suffix in _CODE)

    def _on_path(self, folder: str, file: File) -> bool:
        above = not folder or file.folder == folder or file.folder.startswith(f"{folder}/")
        return above or folder in self.roots or folder.rpartition("/")[2] in self.named

    def _has(self, path: str, inner: str) -> bool:
        """Tell whether a module of the tree has the one that is named inside it, which may be compiled or made."""
        first = inner.partition(".")[0]
        if not first or first.startswith("_") or first.endswith("_pb2"):
            return True
        folders = self.repository.folders
        if path not in folders:  # a file, or one that is compiled
            return False
        within = f"{path}/{first}"
        return within in folders or any(self.repository.has(f"{within}{suffix}") for suffix in _CODE)


def namesakes(repository: Repository, names: Iterable[str], programs: Iterable[str]) -> Namesakes:
    """Return where the tree has modules of these names; ``programs``: the files that are started."""
    wanted = frozenset(names)
    found: dict[str, set[str]] = {}
    for folder, name in _named(repository, wanted):
        found.setdefault(name, set()).add(folder)
    if not found:
        return Namesakes(found={}, roots=frozenset(), named=frozenset(), repository=repository)
    packages = {file.folder for file in repository.named("package.xml")}
    projects = {file.folder for file in repository.named(*_PROJECTS) if not _copied(file.folder, packages)}
    roots = {f"{folder}{below}".lstrip("/") for folder in projects for below in _BELOW}
    return Namesakes(
        found={name: frozenset(folders) for name, folders in found.items()},
        roots=frozenset({*roots, *(program.rpartition("/")[0] for program in programs)}),
        named=repository.once(on_path),
        repository=repository,
    )


def _copied(folder: str, packages: AbstractSet[str]) -> bool:
    """Tell whether a folder lies in another's folder of a package of ROS: no build tool of ROS installs what is there.

    The package's own bindings lie in folders of usual names: ``bindings/python``.
    """
    way: list[str] = []
    while folder and folder not in packages:
        folder, _, name = folder.rpartition("/")
        way.append(name.lower())
        if folder in packages:
            return not _OF_BINDINGS.issuperset(way)
    return False


def _named(repository: Repository, wanted: frozenset[str]) -> Iterator[tuple[str, str]]:
    """Yield the folder above each module of these names with the name; a folder is one if it holds code."""
    for file in repository.suffixed(*_CODE) if wanted else ():
        parts = file.folder.split("/")
        yield from (("/".join(parts[:at]), part) for at, part in enumerate(parts) if part in wanted)
        if (stem := file.name.partition(".")[0]) in wanted:
            yield file.folder, stem
