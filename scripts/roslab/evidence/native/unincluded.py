"""Names of the standard library that a source uses, while none of the headers that it includes has them.

Other compilers, and older releases of GCC, bring them along with other headers. Only sources of which all headers are
known are judged: those of the tree, the compiler's and the C library's.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.c_comments import without_c_comments
from roslab.evidence.lex.includes import includes
from roslab.evidence.native.limits import conditional
from roslab.evidence.native.unlisted import Unlisted
from roslab.knowledge.standard_headers import MissedHeader, missed_headers, standard_headers
from roslab.repository.checkout import File, Repository

MAX_READ = 64 * 1024
MAX_HEADERS = 60
"""Most headers of the tree that one source may reach."""
_SOURCES = (".cpp", ".cc", ".cxx")
_DEFINES = (
    r"\b(?:define|using|class|struct)[ \t]+{0}\b|\btypedef\b[^;\n]*\b{0}[ \t]*;|"
    r"\bconst(?:expr)?\b[^;\n=(]*\b{0}[ \t]*[={{]"
)


def unincluded(repository: Repository, files: Iterable[File]) -> tuple[Dependency, ...]:
    """Return each header that some compiled source lacks, at the first place that uses one of its names.

    Its name is the header's, and its role the name that is used.
    """
    found: dict[str, Dependency] = {}
    unlisted, reading = Unlisted(repository), _Reading(repository)
    for file in files:
        if len(found) == len(missed_headers()):
            break
        if not file.path.endswith(_SOURCES) or places.aside(file.path) or not _by_cmake(file, repository):
            continue
        missed = [each for each in reading.missed(file.path) if each.name not in found]
        if missed and not unlisted.has(file.path):
            found.update({each.name: each for each in missed})
    return tuple(found.values())


def _by_cmake(file: File, repository: Repository) -> bool:
    """Tell whether CMake may compile a source: a CMakeLists.txt lies beside it or above."""
    parts = file.path.split("/")[:-1]
    return any(repository.has("/".join((*parts[:end], "CMakeLists.txt"))) for end in range(len(parts), -1, -1))


class _Reading:
    """The code that was read, each file once: many sources reach the same headers."""

    def __init__(self, repository: Repository) -> None:
        self._repository = repository
        self._included: dict[str, tuple[str, ...] | None] = {}
        self._brought: dict[str, set[str]] = {}
        self._used: dict[str, dict[str, Dependency]] = {}

    def missed(self, path: str) -> list[Dependency]:
        """Return what is missing in a source: in its text and in the headers of the tree that it reaches."""
        reached = self._reached(path)
        brought = {name for each in reached for name in self._brought[each]}
        found: dict[str, Dependency] = {}
        for each in reached:
            for header, place in self._uses(each).items():
                if header not in brought:
                    found.setdefault(header, place)
        texts = [self._text(each) for each in reached] if found else []
        return [
            place
            for place in found.values()
            if not any(re.search(_DEFINES.format(place.role), text) for text in texts if place.role in text)
        ]

    def _reached(self, path: str) -> list[str]:
        """Return a source and the headers of the tree that it reaches, none where one is not known."""
        reached = [path]
        for each in reached:
            if each not in self._included:
                self._included[each] = self._read(each)
            headers = self._included[each]
            if headers is None or len(reached) > MAX_HEADERS:
                return []
            reached += [header for header in headers if header not in reached]
        return reached

    def _read(self, path: str) -> tuple[str, ...] | None:
        """Return the headers of the tree that a file includes, ``None`` where one is not known."""
        headers: dict[str, None] = {}
        brought = self._brought[path] = set[str]()
        for match in includes(self._text(path)):
            header = _of_tree(match[1], path, self._repository, quoted=match[0].endswith('"'))
            if header is None:
                return None
            if header:
                headers[header] = None
            else:
                brought |= standard_headers()[match[1]]
        return tuple(headers)

    def _uses(self, path: str) -> dict[str, Dependency]:
        if path not in self._used:
            text = self._text(path)
            rows = [row for row in missed_headers() if any(each in text for each in row.has)]
            code = without_c_comments(text) if rows else ""
            self._used[path] = {row.header: place for row in rows if (place := _use(row, path, code))}
        return self._used[path]

    def _text(self, path: str) -> str:
        return self._repository.read(path, limit=MAX_READ)


def _use(row: MissedHeader, path: str, code: str) -> Dependency | None:
    """Return the first place that uses a name of a header whatever the compiler is told."""
    for match in row.names.finditer(code):
        if not conditional(code, match.end()):
            line = code.count("\n", 0, match.end()) + 1
            name = match[0].rpartition(":")[2].strip(" \t\n;{}(=!&|")
            return Dependency(namespace="unincluded", name=row.header, strength="used", file=path, line=line, role=name)
    return None


def _of_tree(name: str, path: str, repository: Repository, *, quoted: bool) -> str | None:
    """Return the one file of the tree that an include means, ``""`` for the compiler's, ``None`` for another."""
    beside = posixpath.normpath(posixpath.join(posixpath.dirname(path), name))
    if quoted and repository.has(beside):
        return beside
    if name in standard_headers():
        return ""
    name = posixpath.normpath(name)
    ends = [each.path for each in repository.named(posixpath.basename(name)) if f"/{each.path}".endswith(f"/{name}")]
    return ends[0] if len(ends) == 1 else None
