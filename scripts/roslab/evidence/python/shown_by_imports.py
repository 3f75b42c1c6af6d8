"""Windows that a program opens by a module of its tree: ``from lib.visualizer import plot``."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator, Mapping

from roslab.evidence.dependency import Dependency
from roslab.values.dataclass import replace


def names(statement: re.Match[str]) -> tuple[str, ...]:
    """Return the modules that a statement imports at the top of a file, by their whole names."""
    if statement["indent"]:
        return ()
    plain = statement["plain"] or ""
    return (statement["module"],) if statement["module"] else tuple(part.split()[0] for part in plain.split(","))


def shown_by_imports(imported: Mapping[str, Iterable[str]], calls: Iterable[Dependency]) -> Iterator[Dependency]:
    """Yield each call that opens a window as one of the files that import its module; ``imported``: what files import.

    Python finds a module from the root, from the importing file's folder or from ``src``.
    """
    by_file: dict[str, list[Dependency]] = {}
    for call in calls:
        by_file.setdefault(call.file, []).append(call)
    names = {path.rpartition("/")[2] for path in by_file}
    for file, modules in imported.items() if by_file else ():
        bases = dict.fromkeys(("", posixpath.dirname(file), "src"))
        for name in modules:
            module = f"{name.replace('.', '/')}.py"
            if module.rpartition("/")[2] not in names:
                continue
            paths = (posixpath.join(base, module) for base in bases)
            for call in next((by_file[path] for path in paths if path in by_file and path != file), ()):
                yield replace(call, file=file, line=1)
