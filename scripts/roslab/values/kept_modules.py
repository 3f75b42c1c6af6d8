"""The program's compiled modules in one file, beside those in which Python keeps each by itself.

A plan imports eight to nine hundred small modules. To look for each along the path, and to open, check and read its own
file, is a fifth of its time (``benchmarks/plan.py``). Here only the date and the size of each source are looked at, by
which Python, too, sees whether what it compiled is still true. A module that is new or was changed is imported as ever.

What some modules import, that of the commands first of all, is kept once more for each, in a file of their own, as one
value in which names that many modules have stand once, and in the order in which it was executed: to find, lock and
describe each module would take as long as to execute it. It holds for as long as each of its sources is as it was.
"""

from __future__ import annotations

import marshal
import sys
from collections.abc import Callable, Collection, Iterable, Sequence
from contextlib import suppress
from functools import partial
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import CodeType, ModuleType

from roslab.values.kept_file import DAMAGED, KeptFile, Made, Stamp, stamp

_PROGRAM = f"{__name__.partition('.')[0]}."
_PACKAGE = "/__init__.py"
_HEADER = 16
"""Bytes before the code in Python's own file: magic number, flags, and date and size of the source, four of each.

https://peps.python.org/pep-0552/#specification
"""
Row = tuple[str, str, Stamp, str, CodeType]
"""Of a module that is kept with others: its name, its source and that file's stamp, Python's own file, its code."""


unchanged: dict[str, Stamp] = {}
"""Sources of what was kept together, which were looked at when it was taken, with their stamps."""


def install(*together: str) -> None:
    """Let the modules of the program that are imported from here on come from the file, as far as it has them.

    ``together`` names the modules of which all that they import is kept as one value; none of them imports another one.
    """
    if sys.implementation.name == "cpython" and __spec__:
        sys.meta_path.insert(0, Finder(KeptFile(__spec__, "modules"), KeptFile(__spec__, "together"), together))


class Finder:
    """Finds the modules that are kept, and has those of the program kept that are not."""

    def __init__(self, kept: KeptFile, together: KeptFile, firsts: Collection[str]) -> None:
        self._kept, self._together, self._firsts = kept, together, firsts
        self._executed: list[str] | None = None
        """What was imported since one of the first was asked for, as it was done; ``None`` before and after."""
        self._changed = False
        """Whether one of them was not among what is kept together."""

    def find_spec(self, name: str, path: Sequence[str] | None, _: object = None) -> ModuleSpec | None:
        """Return how a module is loaded that is kept; ``None`` leaves it to the next finder."""
        if not path or not name.startswith(_PROGRAM):
            return None
        made = self._kept.find(name)
        folder = f"{path[0]}/{name.rpartition('.')[2]}"
        # Of a copy of the whole program the modules stand elsewhere
        if made is None or made[0] not in {f"{folder}.py", f"{folder}/__init__.py"}:
            self._kept.add(name, partial(_compiled, name))
            self._executed = None  # the order would lack it
            return None
        if name in self._firsts:
            self._executed, self._changed = [], False
            self._bring(name, made[0])
        source, _, cached, code = made
        loader = _Loader(
            name, source, code, lambda: self._kept.add(name, partial(_compiled, name)), partial(self._done, name)
        )
        return _spec(name, source, cached, loader)

    def _bring(self, first: str, source: str) -> None:
        """Execute what is kept together of the imports of a module, but what is there: each after what it imports."""
        rows = self._rows(first, source)
        new = (row for row in rows if row[0] not in sys.modules)
        packages = {row[0]: _module(row) for row in new if row[1].endswith(_PACKAGE)}
        sys.modules.update(packages)  # modules that a package imports may import others from it
        for row in rows:
            name, code = row[0], row[-1]
            if name in packages or name not in sys.modules:
                sys.modules[name] = module = packages.get(name) or _module(row)
                exec(code, module.__dict__)  # noqa: S102 - as Python does with the code of any module
                parent, _, last = name.rpartition(".")
                setattr(sys.modules[parent], last, module)
            if self._executed is not None:
                self._executed.append(name)

    def _rows(self, first: str, source: str) -> list[Row]:
        """Return what is kept together, nothing of a copy of the program or where a source is not as it was."""
        found = self._together.find(first)
        if found is None or found[0] != source:
            return []
        with suppress(*DAMAGED):
            rows: list[Row] = marshal.loads(found[3])  # noqa: S302 - trusted as Python's own file
            if all(stamp(file) == stamped for _, file, stamped, _, _ in rows):
                unchanged.update((file, stamped) for _, file, stamped, _, _ in rows)
                return rows
        return []

    def _done(self, name: str) -> None:
        """Note that a module was imported by itself; with the first one's end, have the others kept together."""
        if self._executed is None:
            return
        if name not in self._firsts:
            self._executed.append(name)
            self._changed = True
            return
        if self._changed:
            self._together.add(name, partial(self._in_order, name, tuple(self._executed)))
        self._executed = None

    def _in_order(self, name: str, names: Iterable[str]) -> Made | None:
        first = self._kept.find(name)
        found = {name: self._kept.find(name) for name in names}
        rows = [(name, *made[:3], marshal.loads(made[3])) for name, made in found.items() if made]  # noqa: S302
        return (*first[:3], marshal.dumps(rows)) if first and len(rows) == len(found) else None


def _module(row: Row) -> ModuleType:
    """Return a module that is to be executed, as Python makes it."""
    name, source, _, cached, _ = row
    spec = _spec(name, source, cached, SourceFileLoader(name, source))
    module = _Module(name)
    said = {"__spec__": spec, "__loader__": spec.loader, "__file__": source, "__cached__": cached}
    module.__dict__.update(said, __package__=spec.parent)
    if spec.submodule_search_locations is not None:
        module.__path__ = spec.submodule_search_locations
    return module


def _spec(name: str, source: str, cached: str, loader: SourceFileLoader) -> ModuleSpec:
    spec = ModuleSpec(name, loader, origin=source, is_package=source.endswith(_PACKAGE))
    spec.has_location, spec.cached = True, cached
    if spec.submodule_search_locations is not None:
        spec.submodule_search_locations.append(source.removesuffix(_PACKAGE))
    return spec


class _Module(ModuleType):
    """A module that has no ``__getattr__`` of its own, as none of the program has.

    Each ``from … import`` asks a module for its ``__path__``, which only packages have. Until Python 3.12 a module then
    writes a message that nobody sees; a plan would have some eight thousand of them.
    """

    __getattribute__ = object.__getattribute__


class _Loader(SourceFileLoader):
    """Loads a module from its compiled code."""

    def __init__(
        self, name: str, path: str, compiled: bytes | memoryview, anew: Callable[[], None], done: Callable[[], None]
    ) -> None:
        """``anew`` is called where what was kept is damaged, to have it kept anew, ``done`` after the module's code."""
        super().__init__(name, path)
        self._compiled, self._anew, self._done = compiled, anew, done

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Return the module, empty."""
        return _Module(spec.name)

    def exec_module(self, module: ModuleType) -> None:
        """Execute the module."""
        super().exec_module(module)
        self._done()

    def get_code(self, fullname: str) -> CodeType | None:
        """Return the module's code, where what was kept is damaged as Python itself finds it."""
        try:
            code: CodeType = marshal.loads(self._compiled)  # noqa: S302 - trusted as Python's own file
        except DAMAGED:
            self._anew()
            return super().get_code(fullname)
        return code


def _compiled(name: str) -> Made | None:
    """Return what Python has kept of a module that this program imported, if it goes by the date of the source."""
    spec = getattr(sys.modules.get(name), "__spec__", None)
    if spec is None or not spec.origin or not spec.cached:
        return None
    with suppress(OSError, *DAMAGED):
        with open(spec.cached, "rb") as stream:  # noqa: PTH123 - `Path` would be slower
            header, code = stream.read(_HEADER), stream.read()
        found = stamp(spec.origin)
        if found and header[4:] == _by_date(*found):
            return spec.origin, found, spec.cached, marshal.dumps(_at(spec.origin, marshal.loads(code)))  # noqa: S302
    return None


def _at(path: str, code: CodeType) -> CodeType:
    """Return code that says where its source is: Python's own file tells where it was when it was compiled."""
    if code.co_filename == path:
        return code
    parts = (_at(path, each) if isinstance(each, CodeType) else each for each in code.co_consts)
    return code.replace(co_filename=path, co_consts=tuple(parts))


def _by_date(date: int, size: int) -> bytes:
    """Return the header of Python's file for a source, after the magic number."""
    return b"".join((each & 0xFFFFFFFF).to_bytes(4, "little") for each in (0, date // 1_000_000_000, size))
