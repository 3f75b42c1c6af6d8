"""Frameworks of other indexes that the code names by a module within another's, and the releases that pages name."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.pages import pages, text_of
from roslab.evidence.python.modules import modules, setup_scripts
from roslab.knowledge.other_indexes import other_indexes
from roslab.repository.checkout import Repository

_MANIFEST = "pyproject.toml"
DEEPEST = 3
"""Of the folders of manifests that are read."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each framework that the code imports (``value`` its name), then each release that is said of one.

    A release as ``isaacsim 4.5``, by a page, a classifier or an extension's own file at the root.
    """
    if not any(name in module.text for module in modules(repository) for name in _modules()):
        return
    yield from _imported(repository)
    texts = [(file.path, text_of(repository, file)) for file in pages(repository)]
    texts += [(module.file.path, module.text) for module in setup_scripts(repository)]
    texts += [
        (file.path, repository.read(file)) for file in repository.named(_MANIFEST) if file.path.count("/") <= DEEPEST
    ]
    yield from _said(texts)


def _imported(repository: Repository) -> Iterator[Mention]:
    """Yield the frameworks whose module has a dot: the name of its first part alone is another's, too."""
    for row in other_indexes():
        for name in filter(lambda name: "." in name, row.modules):
            for module in modules(repository):
                found = _import(name).search(module.text) if name in module.text else None
                if found and not places.test(module.file.path):
                    line = module.text.count("\n", 0, found.start()) + 1
                    yield Mention(
                        topic="of_other_index",
                        value=row.pip,
                        source="code",
                        file=module.file.path,
                        line=line,
                        text=found[0].strip(),
                    )
                    break


def _said(texts: Iterable[tuple[str, str]]) -> Iterator[Mention]:
    for path, text in texts:
        for name, said in _names():
            for found in said.finditer(text):
                line = text.count("\n", 0, found.start()) + 1
                value = f"{name} {found[1]}"
                yield Mention(topic="of_other_index", value=value, source="readme", file=path, line=line, text=found[0])


@cache
def _modules() -> tuple[str, ...]:
    return tuple(dict.fromkeys(name for row in other_indexes() for name in row.modules))


@cache
def _import(name: str) -> re.Pattern[str]:
    return re.compile(rf"^[ \t]*(?:from|import)[ \t]+{re.escape(name)}(?![A-Za-z0-9])", re.MULTILINE)


@cache
def _names() -> tuple[tuple[str, re.Pattern[str]], ...]:
    """Return each framework with what tells its release: ``Isaac Sim :: 4.5.0``, ``IsaacSim-4.5.0``, ``v2.1``."""
    between = r"[\s:=_/\"'`(*)v-]{0,4}(?:version\s?)?"
    names = {row.pip: row.said for row in other_indexes()}
    return tuple((pip, re.compile(rf"{said}{between}(\d\.\d)", re.IGNORECASE)) for pip, said in names.items())
