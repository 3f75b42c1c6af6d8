"""What the code tells to install for an import that failed: ``raise ImportError("pip install git+https://…")``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.indents import depth
from roslab.evidence.python.modules import Module, modules
from roslab.evidence.python.told import in_string
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_EXCEPT = pattern(
    r"except\b(?:[^:#\n]{0,200}\b(?:ImportError|ModuleNotFoundError|Exception)\b[^:#\n]{0,200}|[ \t]{0,9}):"
)
_WAY = pattern(
    r"pip3?\s+install\s+(?:(?:-U|--upgrade|--user|-q)\s+)*"
    r"(?P<package>git\+https://[\w./@:~-]+\w|[A-Za-z][\w.-]*\w(?:\[[\w,-]+\])?(?:[=~!<>]=[\d.]+\d)?)"
    r"""(?=\s*(?:[`'"),;]|\.(?:\s|["'`]|$)|\\n|$))"""
)
_INSTALLS = pattern(r"\bpip3?\s+install\b")
NEAR = 4_000
"""Most characters behind an import that are read."""
MOST = 12
"""Most lines of a handler that are read."""


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return for each module that is imported in a ``try`` (``value``) what its handler tells to install (``text``)."""
    found: dict[str, Mention] = {}
    for module in modules(repository):
        if "install" in module.words and "except" in module.text and not places.aside(module.file.path):
            for each in _of(module):
                found.setdefault(each.value, each)
    return tuple(found.values())


def _of(module: Module) -> Iterator[Mention]:
    text = module.text
    for match in module.statements:
        behind = text[match.end() : match.end() + NEAR] if match["indent"] else ""
        way = _way(behind, depth(match["indent"])) if "except" in behind else None
        top = (match["module"] or match["plain"].split(",")[0].split()[0]).partition(".")[0]
        if way:
            line = text.count("\n", 0, match.start()) + 1
            yield Mention(topic="told_way", value=top, source="code", file=module.file.path, line=line, text=way)


def _way(behind: str, inside: int) -> str | None:
    """Return the one package that the first handler behind an import tells to install; ``inside``: how deep that is."""
    _, *lines = behind.split("\n", 60)
    told: list[str] = []
    handler = -1
    for line in lines:
        said = line.strip()
        deep = depth(line)
        if not said:
            continue
        if handler >= 0:
            if deep <= handler or len(told) == MOST:
                break
            told.append(line)
        elif deep < inside:
            if not _EXCEPT.match(said):
                return None
            handler = deep
    quoted = [line for line in told if in_string(line.partition("pip")[0])]
    found = [way["package"] for line in quoted for way in _WAY.finditer(line)]
    return found[0] if len(found) == sum(len(_INSTALLS.findall(line)) for line in quoted) == 1 else None
