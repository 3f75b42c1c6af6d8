"""Which files a program reaches by imports, found once for all programs of a tree instead of once for each."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Collection, Iterable, Mapping

MOST = 3_000_000
"""Most imports that are followed for programs of single folders; those of the folders after that are not looked at."""
_Imports = Callable[[str], tuple[str, ...]]


class ImportGraph:
    """The files of a tree and what each imports, as a program finds it: it looks first in its own folder.

    Sets of files are numbers, in which the bit of ``number[file]`` stands for a file; the bits have the order of the
    paths.
    """

    def __init__(
        self,
        files: Iterable[str],
        inside: Mapping[str, Collection[str]],
        tops: Callable[[str], frozenset[str]],
        resolved: Callable[[str, str | None], tuple[str, ...]],
    ) -> None:
        """Take the names in each folder, the first parts of what a file imports, and the files that these run.

        ``resolved(file, folder)`` is what a program of that folder runs, or of none that matters. It has to be the same
        for both where no name in the folder is such a first part.
        """
        self.files = sorted(files)
        self.number = {file: number for number, file in enumerate(self.files)}
        self.left = MOST
        self._inside, self._tops, self._resolved = inside, tops, resolved
        self._imports: dict[str | None, dict[str, tuple[str, ...]]] = {None: {}}
        self._reach: dict[str | None, dict[str, int]] = {None: {}}
        self._importing: dict[str, int] = {}
        self._touched: dict[str, tuple[int, int]] = {}
        self._known_tops: dict[str, frozenset[str]] = {}

    def reach(self, program: str) -> int | None:
        """Return the files that a program runs, itself among them; ``None`` where that would be too much work."""
        folder = posixpath.dirname(program)
        alone = self._from(program, None)
        if not alone & self._where_it_matters(folder):
            return alone
        return self._from(program, folder) if self.left > 0 else None

    def imports(self, file: str, folder: str | None) -> tuple[str, ...]:
        """Return the files that an import of a file runs, for a program of a folder."""
        if folder is not None and self._tops_of(file).isdisjoint(self._inside.get(folder, ())):
            folder = None
        known = self._imports.setdefault(folder, {})
        if file not in known:
            known[file] = tuple(dict.fromkeys(self._resolved(file, folder)))
            for top in self._tops_of(file) if folder is None else ():
                self._importing[top] = self._importing.get(top, 0) | self.bit(file)
        return known[file]

    def _tops_of(self, file: str) -> frozenset[str]:
        if file not in self._known_tops:
            self._known_tops[file] = self._tops(file)
        return self._known_tops[file]

    def bit(self, file: str) -> int:
        """Return the set with that file alone."""
        return 1 << self.number[file]

    def first(self, files: int) -> str:
        """Return the first file of a set that has one."""
        return self.files[(files & -files).bit_length() - 1]

    def _where_it_matters(self, folder: str) -> int:
        """Return those of the files looked at whose imports may be other ones for a program of a folder."""
        known = len(self._imports[None])
        if folder not in self._touched or self._touched[folder][0] != known:
            files = 0
            for name in self._inside.get(folder, ()):
                files |= self._importing.get(name, 0)
            self._touched[folder] = (known, files)
        return self._touched[folder][1]

    def _from(self, program: str, folder: str | None) -> int:
        reach = self._reach.setdefault(folder, {})
        if program not in reach:
            groups = components(program, lambda file: self.imports(file, folder), reach, self.bit)
            if folder is not None:
                self.left -= sum(1 + len(self.imports(file, folder)) for group in groups for file in group)
        return reach[program]


def components(start: str, imports: _Imports, reach: dict[str, int], bit: Callable[[str], int]) -> list[list[str]]:
    """Fill in what each file reaches that is reached from ``start``; return the groups that import each other.

    This is Tarjan's way to find strongly connected components, without recursion: each import is followed once,
    however many files reach it.
    """
    order = {start: 0}
    lowest = {start: 0}
    open_, work = [start], [(start, iter(imports(start)))]
    groups: list[list[str]] = []
    while work:
        file, left = work[-1]
        for other in left:
            if other in reach:
                continue
            if other not in order:
                order[other] = lowest[other] = len(order)
                open_.append(other)
                work.append((other, iter(imports(other))))
                break
            lowest[file] = min(lowest[file], order[other])
        else:
            work.pop()
            if work:
                lowest[work[-1][0]] = min(lowest[work[-1][0]], lowest[file])
            if lowest[file] == order[file]:
                at = next(place for place in range(len(open_) - 1, -1, -1) if open_[place] == file)
                groups.append(open_[at:])
                del open_[at:]
                files = 0
                for each in groups[-1]:
                    files |= bit(each)
                    for other in imports(each):
                        files |= reach.get(other, 0)
                reach.update(dict.fromkeys(groups[-1], files))
    return groups
