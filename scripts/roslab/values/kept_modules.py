"""The program's compiled modules in one file, beside those in which Python keeps each by itself.

A plan imports some seven hundred small modules. To look for each along the path, and to open, check and read its own
file, is a fifth of its time (``benchmarks/plan.py``). Here only the date and the size of each source are looked at, by
which Python, too, sees whether what it compiled is still true. A module that is new or was changed is imported as ever.
"""

from __future__ import annotations

import marshal
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import CodeType, ModuleType

from roslab.values.kept_file import DAMAGED, KeptFile, Made, stamp

_PROGRAM = f"{__name__.partition('.')[0]}."
_HEADER = 16
"""Bytes before the code in Python's own file: magic number, flags, and date and size of the source, four of each.

https://peps.python.org/pep-0552/#specification
"""


def install() -> None:
    """Let the modules of the program that are imported from here on come from the file, as far as it has them."""
    if sys.implementation.name == "cpython" and __spec__:
        sys.meta_path.insert(0, Finder(KeptFile(__spec__, "modules")))


class Finder:
    """Finds the modules that are kept, and has those of the program kept that are not."""

    def __init__(self, kept: KeptFile) -> None:
        self._kept = kept

    def find_spec(self, name: str, path: Sequence[str] | None, _: object = None) -> ModuleSpec | None:
        """Return how a module is loaded that is kept; ``None`` leaves it to the next finder."""
        if not path or not name.startswith(_PROGRAM):
            return None
        made = self._kept.find(name)
        folder = f"{path[0]}/{name.rpartition('.')[2]}"
        # Of a copy of the whole program the modules stand elsewhere
        if made is None or made[0] not in {f"{folder}.py", f"{folder}/__init__.py"}:
            self._kept.add(name, partial(_compiled, name))
            return None
        source, _, cached, code = made
        is_package = len(source) > len(folder) + 3
        loader = _Loader(name, source, code, lambda: self._kept.add(name, partial(_compiled, name)))
        spec = ModuleSpec(name, loader, origin=source, is_package=is_package)
        spec.has_location, spec.cached = True, cached
        if spec.submodule_search_locations is not None:
            spec.submodule_search_locations.append(folder)
        return spec


class _Module(ModuleType):
    """A module that has no ``__getattr__`` of its own, as none of the program has.

    Each ``from … import`` asks a module for its ``__path__``, which only packages have. Until Python 3.12 a module then
    writes a message that nobody sees; a plan would have some eight thousand of them.
    """

    __getattribute__ = object.__getattribute__


class _Loader(SourceFileLoader):
    """Loads a module from its compiled code."""

    def __init__(self, name: str, path: str, compiled: bytes, anew: Callable[[], None]) -> None:
        """``anew`` is called where what was kept is damaged, to have it kept anew."""
        super().__init__(name, path)
        self._compiled, self._anew = compiled, anew

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Return the module, empty."""
        return _Module(spec.name)

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
