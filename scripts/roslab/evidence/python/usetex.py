"""Programs whose plots have their text set by LaTeX: ``rcParams["text.usetex"] = True``. Without it they stop.

https://matplotlib.org/stable/users/explain/text/usetex.html, read 2026-11-28
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping
from itertools import accumulate, islice

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.lex.indents import conditional
from roslab.evidence.python.from_root import LAYOUTS
from roslab.evidence.python.modules import Module, has_guard, modules
from roslab.evidence.python.plot_backends import uncalled
from roslab.evidence.python.through_modules import of_tree
from roslab.evidence.python.top_level import first_statement
from roslab.evidence.roles import LATEX
from roslab.knowledge.latex import latex
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_SET = pattern(
    r"^[ \t]*(?:[^#\n]{0,200}[\[{(,\s])?"
    r"(?:[\"']text\.usetex[\"'](?:\][ \t]*=|[ \t]*:)|usetex[ \t]*=)[ \t]*True\b"
)
_WORD = "usetex"
MOST = 20
"""Most lines of a module that are tried: for each, all modules are searched for what calls its function."""


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return the first line that does so under no condition in each module, with the programs that reach it."""
    return repository.once(_read)


def _read(repository: Repository) -> tuple[Mention, ...]:
    every = modules(repository)
    setting = {module.file.path: line for module in every if _WORD in module.text and (line := _line(module, every))}
    ours = {path: line for path, line in setting.items() if not (places.test(path) or places.vendored(path))}
    programs = {each.file.path for each in every if has_guard(each) or first_statement(each.text)} if ours else set()
    importing = _importing(repository) if ours else {}
    return tuple(
        Mention(
            topic="usetex",
            value=path,
            source="code",
            file=path,
            line=line,
            text="text.usetex",
            files=tuple(file for file in _reaching(path, importing) if file in programs),
        )
        for path, line in ours.items()
    )


def _importing(repository: Repository) -> dict[str, list[str]]:
    """Return for each module those that import it at their top, by its path from the root or beside them."""
    found: dict[str, list[str]] = {}
    tree = of_tree(repository)
    for file in tree.by_file:
        for name in tree.imported(file):
            path = name.rstrip("/").replace(".", "/")
            for folder in dict.fromkeys(("", *LAYOUTS, posixpath.dirname(file))):
                whole = posixpath.join(folder, path)
                for each in (f"{whole}.py", f"{whole}/__init__.py"):
                    if each in tree.by_file:
                        found.setdefault(each, []).append(file)
    return found


def _reaching(path: str, importing: Mapping[str, list[str]]) -> Iterator[str]:
    """Yield a module and those that import it, and these in turn."""
    found = {path: None}
    queue = [path]
    for each in queue:
        new = dict.fromkeys(file for file in importing.get(each, ()) if file not in found)
        found |= new
        queue += new
    yield from found


def _line(module: Module, others: tuple[Module, ...]) -> int:
    """Return the number of that line, ``0`` for none."""
    lines = module.text.split("\n")
    starts = accumulate((len(line) + 1 for line in lines), initial=0)
    setting = (
        (number, start) for number, (line, start) in enumerate(zip(lines, starts, strict=False), 1) if _sets(line)
    )
    for number, start in islice(setting, MOST):
        if not (conditional(module.text, start) or uncalled(module, start, others)):
            return number
    return 0


def _sets(line: str) -> bool:
    return _WORD in line and bool(_SET.match(line))


def packages(repository: Repository) -> Iterator[Dependency]:
    """Yield what matplotlib needs for it, for each of the programs, of which only the default command's counts."""
    for said in read(repository):
        for file in said.files:
            line = said.line if file == said.file else 1
            for name in latex():
                yield Dependency(namespace="apt", name=name, strength="used", file=file, line=line, role=LATEX)
