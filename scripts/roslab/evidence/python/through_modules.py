"""Modules of the tree that nodes of ROS import: what these import fails the node as much as its own imports do."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.evidence.python.import_graph import ImportGraph
from roslab.evidence.python.modules import Module, modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_FROM = pattern(r"^from[ \t]+(\.*)([\w.]*)[ \t]+import[ \t]+(\([^()]*\)|[^\n#;]*)", re.MULTILINE)
_IMPORT = pattern(r"^import[ \t]+([A-Za-z_][^\n#;]*)", re.MULTILINE)
_INIT = "__init__"
_SUFFIX = ".py"
_LISTS = ("listdir(", "scandir(", "iter_modules(", "walk_packages(", "glob(")
_BY_NAME = ("__import__(", "import_module(")
"""Calls of a package that lists its folder and imports what lies there by its name."""


def of_tree(repository: Repository) -> Modules:
    """Return the modules of a repository, whose imports are read once for all who follow them."""
    return repository.once(_of_tree)


def _of_tree(repository: Repository) -> Modules:
    return Modules(modules(repository))


class Modules:
    """The modules of a tree by the names under which others import them.

    Imports inside of functions and of ``try`` may never run, and are not followed. A module is found by its whole name
    from the folder above its outermost package, or beside the file that imports it.
    """

    def __init__(self, found: Iterable[Module]) -> None:
        self.by_file = {module.file.path: module for module in found}
        packages = {module.file.folder for module in self.by_file.values() if module.file.name == f"{_INIT}.py"}
        self._by_name: dict[str, list[str]] = {}
        self._in_folder: dict[str, list[str]] = {}
        for path in self.by_file:
            if path.endswith(_SUFFIX):  # a program without it is started, and never imported
                self._by_name.setdefault(_importable(path, packages), []).append(path)
            self._in_folder.setdefault(posixpath.dirname(path), []).append(path)
        self._inside = names_inside(path for path in self.by_file if path.endswith(_SUFFIX))
        self._written: dict[str, tuple[str, ...]] = {}
        self._imports: dict[str, tuple[str, ...]] = {}
        self.graph = ImportGraph(self.by_file, self._inside, self._tops, self._resolved)

    def beside(self, file: str) -> AbstractSet[str]:
        """Return the names of the modules and of the folders that lie beside a file."""
        return self._inside.get(posixpath.dirname(file), frozenset())

    def reached(self, starts: Iterable[str], known: AbstractSet[str] = frozenset()) -> frozenset[str]:
        """Return the files that these import at their top, by whichever way, but for those that are ``known``."""
        queue = [*starts]
        reached: set[str] = set()
        while queue:
            new = [file for file in self.graph.imports(queue.pop(), None) if not (file in reached or file in known)]
            reached.update(new)
            queue += new
        return frozenset(reached)

    def _tops(self, file: str) -> frozenset[str]:
        return frozenset(name.partition(".")[0] for name in self._imported_by(file) if not name.endswith("/"))

    def imported(self, file: str) -> tuple[str, ...]:
        """Return what a module imports at its top, each once, as ``_imported`` names it."""
        if file not in self._written:
            names = _imported(self.by_file[file].text, posixpath.dirname(file))
            self._written[file] = tuple(dict.fromkeys(names))
        return self._written[file]

    def _imported_by(self, file: str) -> tuple[str, ...]:
        if file not in self._imports:
            self._imports[file] = tuple(dict.fromkeys((*self.imported(file), *self._beside(file))))
        return self._imports[file]

    def _beside(self, file: str) -> Iterator[str]:
        """Yield the modules beside the ``__init__.py`` of a package that imports all that lies in its folder."""
        (folder, name), text = posixpath.split(file), self.by_file[file].text
        whole = name == f"{_INIT}.py" and any(call in text for call in _LISTS)
        for path in self._in_folder[folder] if whole and folder and any(call in text for call in _BY_NAME) else ():
            if path != file:
                yield f"{path.removesuffix('.py')}/"

    def _resolved(self, file: str, folder: str | None) -> tuple[str, ...]:
        places = (posixpath.dirname(file), *(() if folder is None else (folder,)))
        return tuple(found for name in self._imported_by(file) for found in self._found(name, file, places))

    def _found(self, name: str, file: str, places: Iterable[str]) -> Iterator[str]:
        """Yield the files that an import runs: the module, and the packages around it."""
        if name.endswith("/"):
            yield from (path for path in (f"{name[:-1]}.py", f"{name}{_INIT}.py") if path in self.by_file)
            return
        parts = name.split(".")
        for place in places:
            if parts[0] not in self._inside.get(place, ()):
                continue
            whole = posixpath.join(place, *parts)
            near = [path for path in (f"{whole}.py", f"{whole}/{_INIT}.py") if path in self.by_file and path != file]
            if near:
                yield from near
                return
        for end in range(1, len(parts) + 1):
            yield from self._by_name.get(".".join(parts[:end]), ())


def names_inside(files: Iterable[str]) -> dict[str, set[str]]:
    """Return the names of the modules and of the folders in each folder of these files."""
    found: dict[str, set[str]] = {}
    for file in files:
        folder, name = posixpath.split(file.removesuffix(".py"))
        while name not in found.setdefault(folder, set()):
            found[folder].add(name)
            folder, name = posixpath.split(folder)
            if not name:
                break
    return found


def _importable(path: str, packages: Collection[str]) -> str:
    """Return the name by which a module is imported: with those of the packages around it."""
    folder, name = posixpath.split(path.removesuffix(".py"))
    parts = [] if name == _INIT else [name]
    while folder and folder in packages:
        folder, name = posixpath.split(folder)
        parts.insert(0, name)
    return ".".join(parts)


def _imported(text: str, folder: str) -> Iterator[str]:
    """Yield the whole names that a module imports at its top, and for relative ones their paths without an ending.

    What stands behind ``import`` may be a module or something in one.
    """
    for match in _IMPORT.finditer(text):
        yield from (part.split()[0] for part in match[1].split(",") if part.split())
    for match in _FROM.finditer(text):
        dots, module, words = match.groups()
        parts = (word.split()[0] for word in words.strip("()").split(",") if word.split())
        names = [module, *(f"{module}.{part}".lstrip(".") for part in parts)]
        if not dots:
            yield from names
            continue
        base = "/".join([folder, *[".."] * (len(dots) - 1)])
        yield from (f"{posixpath.normpath(posixpath.join(base, name.replace('.', '/')))}/" for name in names)
