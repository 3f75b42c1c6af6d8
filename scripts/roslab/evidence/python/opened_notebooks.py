"""What the notebooks import that a page at the root has the reader open: needed as what a program imports."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.python import notebooks
from roslab.evidence.python.imports import modules_of
from roslab.evidence.python.statements import statements
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace

_END = ".ipynb"


def used_in_notebooks(
    repository: Repository, found: Iterable[Dependency], mentions: Iterable[Mention]
) -> Iterator[Dependency]:
    """Yield the imports, ``used`` where one that nothing else needs is of such a notebook, at its place there.

    ``mentions``: the files that sentences name, and the commands of pages.
    """
    needed = _needed(repository, mentions)
    for each in found:
        tried = each.namespace == "import" and each.strength == "optional"
        place = needed.get(each.name) if tried else None
        yield replace(each, strength="used", file=place[0], line=place[1]) if place else each


def _needed(repository: Repository, mentions: Iterable[Mention]) -> dict[str, tuple[str, int]]:
    """Return the modules that the notebooks import outside of functions, each at its first place."""
    needed: dict[str, tuple[str, int]] = {}
    named = dict.fromkeys(file for said in mentions if "/" not in said.file for file in _opened(said))
    for file in (each for each in notebooks.files(repository) if each.path in named and not _aside(each.path)):
        for line, code in notebooks.imports(repository.read(file, limit=notebooks.MAX_SIZE)):
            for match in statements(code):
                for top in modules_of(match) if not match["indent"] else ():
                    needed.setdefault(top, (file.path, line))
    return needed


def _opened(said: Mention) -> tuple[str, ...]:
    if said.topic == "pointed":
        return (said.value,) if said.value.endswith(_END) else ()
    started = said.topic == "command" and said.value.startswith("jupyter")
    return tuple(file for file in said.files if started and file.endswith(_END))


def _aside(path: str) -> bool:
    return places.vendored(path) or places.test(path) or places.documentation(path)
