"""Compiled patterns, kept in ``__pycache__`` as Python keeps its compiled modules there.

To compile the patterns of one plan takes an eighth of its time (``benchmarks/plan.py``), and Python has no public way
to keep them: here stands what its ``re.compile`` does, https://github.com/python/cpython/blob/3.11/Lib/re/_compiler.py,
in two halves, the slow one of which is kept. Each kept form is of one pattern and one release of Python. These halves
are private to Python: they are used in the releases in which they were seen to do what ``re.compile`` does, and in
every other one patterns are compiled anew. What is kept is the form that begins with a word (``word_first``).
"""

from __future__ import annotations

import atexit
import marshal
import os
import re
import sys
from contextlib import suppress

SEEN = frozenset({(3, 11), (3, 12), (3, 13)})
"""Releases of CPython in which the kept forms of all patterns were seen to be equal to compiled ones (2026-11-23)."""
_KEEPS = sys.implementation.name == "cpython" and sys.version_info[:2] in SEEN
if _KEEPS:
    import _sre  # type: ignore[import-not-found]
    from re import _compiler, _parser  # type: ignore[attr-defined]

at_once = re.compile
"""Python's own, also where a library is imported whose patterns wait."""
MAX_KEPT = 3_000
"""Most patterns of a file: it begins anew where more came together, of versions of this program before."""
_RELEASE = (sys.version, sys.byteorder, "word first")
"""What the compiled form of a pattern depends on, and how it is written before it is compiled."""
_Form = tuple[int, bytes, int, dict[str, int], tuple[str | None, ...]]
"""Its flags, its code, how many groups it has, and their names in either direction."""
_kept: dict[tuple[str, int], _Form] | None = None


def compiled(source: str, flags: int) -> re.Pattern[str]:
    """Return what ``re.compile`` does, and raise what it raises."""
    if not _KEEPS:
        from roslab.values.word_first import word_first  # noqa: PLC0415 - only where a pattern is compiled anew

        return at_once(word_first(source, flags), flags)
    forms = _forms()
    key = (source, int(flags))
    if key not in forms:
        forms[key] = _form(*key)
        atexit.unregister(_write)
        atexit.register(_write)
    all_flags, code, groups, named, names = forms[key]
    found: re.Pattern[str] = _sre.compile(source, all_flags, memoryview(code).cast("I").tolist(), groups, named, names)
    return found


def _form(source: str, flags: int) -> _Form:
    """Return the slow half of ``re.compile``."""
    from array import array  # noqa: PLC0415 - nothing is compiled where all patterns are kept

    from roslab.values.word_first import word_first  # noqa: PLC0415 - as above

    parsed = _parser.parse(word_first(source, flags), flags)

    code = array("I", _compiler._code(parsed, flags)).tobytes()
    state = parsed.state
    names: list[str | None] = [None] * state.groups
    for name, number in state.groupdict.items():
        names[number] = name
    return int(flags | state.flags), code, state.groups - 1, state.groupdict, tuple(names)


def _file() -> str | None:
    module = __spec__.cached if __spec__ else None
    return module and f"{module.removesuffix('.pyc')}.patterns"


def _forms() -> dict[tuple[str, int], _Form]:
    """Return the kept patterns by source and flags, those that the file has to begin with."""
    global _kept  # noqa: PLW0603 - as Python has one table of modules
    if _kept is None:
        _kept = {}
        file = _file()
        with suppress(OSError, EOFError, ValueError, TypeError):  # none yet, or one that is damaged
            with open(file or "", "rb") as stream:  # noqa: PTH123 - `Path` would be slower
                release, forms = marshal.loads(stream.read())  # noqa: S302 - trusted as the modules beside it
            if release == _RELEASE and len(forms) < MAX_KEPT:
                _kept = forms
    return _kept


def _write() -> None:
    """Keep the patterns, where Python keeps its modules: of two programs at once, the later one's remain."""
    file = _file()
    if file is None or sys.dont_write_bytecode:
        return
    own = f"{file}.{os.getpid()}-{os.urandom(4).hex()}"
    with suppress(OSError):  # the folder cannot be written
        with open(own, "wb") as stream:  # noqa: PTH123
            stream.write(marshal.dumps((_RELEASE, _kept)))
        os.replace(own, file)  # noqa: PTH105
