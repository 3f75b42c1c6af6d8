"""Code that imports the repository by the name of its folder: the folder above the checkout is on Python's path."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import Module, modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_NAMED = pattern(r"(?:from|import)[ \t]+([A-Za-z_]\w*)\.(\w+)")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first import of the tree by a name that only the folder of the checkout can have.

    The module puts the folder above the checkout on Python's path, the tree has what is imported below that name, and
    nothing at its root is called so.
    """
    for module in modules(repository):
        if "sys.path" not in module.text or "__file__" not in module.text or places.test(module.file.path):
            continue
        from roslab.evidence.python.above_checkout import reaches_above  # noqa: PLC0415 - it imports Python's own parser

        if (found := _import(module, repository)) and reaches_above(module):
            yield found
            return


def _import(module: Module, repository: Repository) -> Mention | None:
    for match in module.statements:
        named = _NAMED.match(match[0].strip())
        if named is None:
            continue
        name, below = named.groups()
        if repository.has(f"{name}.py") or name in repository.folders:
            continue
        if repository.has(f"{below}.py") or below in repository.folders:
            line = module.text.count("\n", 0, match.start()) + 1
            return Mention(
                topic="own_spelling", value=name, source="code", file=module.file.path, line=line, text=named[0]
            )
    return None
