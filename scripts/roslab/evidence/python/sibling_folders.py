"""Modules that a program reaches by their bare name, and that lie in another folder than the program's own."""

from __future__ import annotations

import posixpath
import sys
from collections import deque
from collections.abc import Iterable, Iterator, Mapping
from functools import cache, reduce
from operator import or_

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.from_root import CODE, LAYOUTS, installs_itself, modules_in
from roslab.evidence.python.import_graph import ImportGraph
from roslab.evidence.python.modules import Module, has_guard, modules, run_by_pages
from roslab.evidence.python.through_modules import names_inside, of_tree
from roslab.knowledge.frameworks import imports as known_imports
from roslab.knowledge.standard_modules import standard_modules
from roslab.repository.checkout import Repository

_INIT = "__init__.py"
_PATH = "sys.path"
DEEPEST = 1
"""Folders above a program that may be offered as a command."""


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each folder without which an import fails that a program reaches, also by the modules that it imports.

    It is the only one of the tree that has a file of that name, and Python looks neither there nor in what is installed
    under that name (https://docs.python.org/3/library/sys.html#sys.path, read 2026-11-27). None that has a module of
    the standard library's or a known package's name, which it would hide, and none for a program that adds to Python's
    path by itself. ``inside`` is the folder, ``files`` the modules in it.
    """
    if installs_itself(repository):
        return
    texts = {module.file.path: module.text for module in modules(repository)}
    folders = _only_folders(repository, texts)
    if not folders:
        return
    run = run_by_pages(mentions)
    tree = _Tree(repository, texts, folders)
    programs = [module.file.path for module in modules(repository) if module.file.path in run or _offered(module)]
    found = {path: tuple(tree.needed_by(path)) for path in sorted(programs, key=lambda path: path not in run)}
    for path in programs:
        yield from found[path]


def _offered(module: Module) -> bool:
    """Tell whether a program may be offered as a command though no page names it."""
    return module.file.path.count("/") <= DEEPEST and has_guard(module)


class _Tree:
    """The modules of a repository, with what each imports at its top."""

    def __init__(self, repository: Repository, texts: Mapping[str, str], folders: Mapping[str, str]) -> None:
        self._repository, self._texts, self._folders = repository, texts, folders
        self._modules = of_tree(repository)
        self._inside = names_inside((*(file.path for file in repository.suffixed(".py")), *repository.folders))
        self._graph = ImportGraph(texts, self._inside, self._tops, self._resolved)
        self._needing: dict[str, int] = {}
        """The files that import a module of a single folder, where the program's own folder does not have it."""
        self._adding = sum(self._graph.bit(file) for file, text in texts.items() if _PATH in text)

    def needed_by(self, program: str) -> Iterator[Mention]:
        """Yield the folders that a program needs, in the order in which its imports come to them."""
        files, own = self._graph.reach(program), posixpath.dirname(program)
        if files is None or files & self._adding:
            return
        needed = {top for top, needing in self._needing.items() if needing & files and self._folders[top] != own}
        left = {self._folders[top] for top in needed}
        needing = reduce(or_, (self._needing[top] for top in needed), 0)
        seen, queue = {program}, deque([program])
        while queue and left and self._graph.left > 0:
            file = queue.popleft()
            for top in self._tops_in_order(file) if needing >> self._graph.number[file] & 1 else ():
                if top in needed and self._folders[top] in left:
                    left.discard(self._folders[top])
                    yield self._mention(top, file, self._folders[top], program)
            imports = self._graph.imports(file, own)
            self._graph.left -= len(imports)
            queue += [path for path in imports if path not in seen]
            seen.update(imports)

    def _tops_in_order(self, file: str) -> Iterator[str]:
        return (name.partition(".")[0] for name in self._modules.imported(file) if not name.endswith("/"))

    def _tops(self, file: str) -> frozenset[str]:
        return frozenset(self._tops_in_order(file))

    def _resolved(self, file: str, folder: str | None) -> tuple[str, ...]:
        found: list[str] = []
        searched = ("", *LAYOUTS) if folder is None else (folder, "", *LAYOUTS)
        for name in self._modules.imported(file):
            reached, there = self._files(name, searched)
            top = name.partition(".")[0]
            if not there and top in self._folders:
                self._needing[top] = self._needing.get(top, 0) | self._graph.bit(file)
                reached = [f"{self._folders[top]}/{top}.py"]
            found += reached
        return tuple(found)

    def _files(self, name: str, searched: Iterable[str]) -> tuple[list[str], bool]:
        """Return the files that an import runs, and whether a folder has its module; a folder alone is one too."""
        if name.endswith("/"):
            return [path for path in (f"{name[:-1]}.py", f"{name}{_INIT}") if path in self._texts], True
        parts = name.split(".")
        for folder in searched:
            if parts[0] in self._inside.get(folder, ()):
                whole = [posixpath.join(folder, *parts[:end]) for end in range(1, len(parts) + 1)]
                files = (path for each in whole for path in (f"{each}/{_INIT}", f"{each}.py"))
                return [path for path in files if path in self._texts], True
        return [], False

    def _mention(self, name: str, file: str, folder: str, program: str) -> Mention:
        lines = self._texts[file].split("\n")
        number = next((at for at, line in enumerate(lines, 1) if "import" in line and name in line), 1)
        return Mention(
            topic="sibling_folder",
            value=name,
            source="code",
            file=program,
            line=number if file == program else 1,
            text=f"import {name}" if file == program else f"import {name} in {file}:{number}",
            files=tuple(sorted(self._repository.once(modules_in)[folder])),
            inside=folder,
        )


def _only_folders(repository: Repository, texts: Mapping[str, str]) -> dict[str, str]:
    """Return the modules that one folder alone has, with it: no other, no folder and no compiled file is called so."""
    found: dict[str, set[str]] = {}
    for file in repository.suffixed(*CODE):
        found.setdefault(file.name.partition(".")[0], set()).add(file.folder)
    named = {part for folder in repository.folders for part in folder.split("/")}
    known = known_modules()
    taken = known | named
    inside = repository.once(modules_in)
    only: dict[str, str] = {}
    hides: dict[str, bool] = {}
    for name, folders in found.items():
        folder = next(iter(folders))
        if len(folders) > 1 or not folder or folder in LAYOUTS or name in taken or name.startswith("__"):
            continue
        path = f"{folder}/{name}.py"
        if path not in texts or places.test(path) or "\nfrom ." in f"\n{texts[path]}":
            continue
        if folder not in hides:
            hides[folder] = not known.isdisjoint(inside[folder])
        if not hides[folder]:
            only[name] = folder
    return only


@cache
def known_modules() -> frozenset[str]:
    """Return the names of the standard library's modules and of known packages, which none of the tree may hide."""
    return frozenset({*sys.stdlib_module_names, *standard_modules(), *known_imports()})
