"""Links to a project's page of pip's index, in comments and on pages: they name a package, whatever its module."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import end_of_line
from roslab.evidence.places import documentation, test, vendored
from roslab.evidence.python.modules import MAX_READ, modules
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern

_HINT = "pypi"
_LINK = pattern(r"\bpypi\.(?:python\.)?org/(?:project|pypi|p|simple)/([A-Za-z0-9](?:[\w.-]{0,80}[A-Za-z0-9])?)")
_PAGES = (".md", ".rst", ".txt")
_MOST_PAGES = 100


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return each package that a link names (``value``), at its first place; no badge's, which are pictures."""
    found: dict[str, Mention] = {}
    for file, text in _texts(repository):
        for match in _LINK.finditer(text) if _HINT in text else ():
            line = text.count("\n", 0, match.start()) + 1
            said = text[text.rfind("\n", 0, match.start()) + 1 : end_of_line(text, match.start())].strip()[:200]
            mention = Mention(topic="index_link", value=match[1], source="code", file=file.path, line=line, text=said)
            found.setdefault(f"{canonicalize_name(match[1])}", mention)
    return tuple(found.values())


def _texts(repository: Repository) -> Iterator[tuple[File, str]]:
    """Yield the pages, those nearest to the root first, and the modules."""
    pages = [each for each in repository.suffixed(*_PAGES) if not (vendored(each.path) or documentation(each.path))]
    for file in nearest(pages)[:_MOST_PAGES]:
        yield file, repository.read(file, limit=MAX_READ)
    yield from ((module.file, module.text) for module in modules(repository) if not test(module.file.path))
