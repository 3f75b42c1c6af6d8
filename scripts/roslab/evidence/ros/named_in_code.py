"""Addresses of repositories that the code names, in comments mostly: one may hold what the code is compiled with."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.repository.checkout import Repository, nearest
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 2_000
"""Most files that are opened, those nearest to the root first."""
MAX_FOUND = 50
BEFORE = 400
"""Most characters of a line before an address."""
_CODE = (".cpp", ".cc", ".cxx", ".h", ".hpp", ".py", ".launch", ".yaml", ".xacro")
_ADDRESS = pattern(r"https://(?:github|gitlab)\.com/[\w-]+/([\w.-]*\w)(?:/(?:-/)?(?:blob|tree)/([\w.-]+))?")
_TAKEN = pattern(
    r"\b(?:taken|adapted|copied|based|borrowed|ported|derived|modified|forked|stolen)\b[^\n]{0,40}\b(?:from|on|of)\b",
    re.IGNORECASE,
)


def read(repository: Repository) -> tuple[GitSource, ...]:
    """Return each repository once, at its first place and with the first branch named; nothing of copied code."""
    found: dict[str, GitSource] = {}
    files = [f for f in repository.suffixed(*_CODE) if f.size <= MAX_SIZE and not places.vendored(f.path)]
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        for match in _ADDRESS.finditer(text):
            url = text[match.start() : match.end(1)].removesuffix(".git")
            first = found.get(url)
            line = text.rfind("\n", 0, match.start()) + 1
            taken = bool(_TAKEN.search(text, max(line, match.start() - BEFORE), match.start()))
            if first and match[2] and (not first.ref or (taken and not first.taken)):
                found[url] = replace(first, ref=match[2], taken=taken)
            elif not first and len(found) < MAX_FOUND:
                found[url] = GitSource(
                    name=match[1].removesuffix(".git"),
                    url=url,
                    ref=match[2],
                    strength="prose",
                    file=file.path,
                    line=text.count("\n", 0, match.start()) + 1,
                    kind="link",
                    taken=taken,
                )
    return tuple(found.values())
