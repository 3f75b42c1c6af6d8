"""Options of CMake without which programs are not built, as a page or CI tells, and which are off by themselves."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Literal

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose import ci
from roslab.evidence.prose.pages import pages
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 400
MAX_PARAGRAPH = 2_000
_BLANK = pattern(r"\n[ \t]*\n")
_PROGRAMS = pattern(r"\b(?:executables?|binar(?:y|ies)|programs?)\b", re.IGNORECASE)
_SET = pattern(
    r"\b(?:set|setting|turn|turning|enable|enabling|with)\b[^.\n]{0,80}?`{0,2}(?:-D)?\b([A-Z][A-Z0-9]*_[A-Z0-9_]+)`{0,2}"
    r"\s{0,3}(?:option\s|variable\s)?(?:set\s)?(?:to|=)\s{0,3}`{0,2}(?:ON|TRUE|1)\b"
)
"""A sentence that has the reader set an option: ``after setting the CMake variable `BUILD_APPS` to `ON```."""
_FENCE = pattern(r"^[ \t]*(?:```|~~~)[^\n]*\n.*?^[ \t]*(?:```|~~~)[^\n]*$", re.MULTILINE | re.DOTALL)
_CONFIGURE = pattern(r"^[^\n#]{0,200}\bcmake\b[^\n]{0,2000}", re.MULTILINE)
_ON = pattern(r"\s-D ?([A-Za-z_]\w*)(?::[A-Za-z]*)?=(?:ON|TRUE|1)(?=\s|$)", re.IGNORECASE)
_ELSEWHERE = pattern(r"\bgit\s+clone\b|\bcmake\s+--build\b")
_STARTS = pattern(
    r"(?:^|(?<!\bcd)[\s/])(?:\./|bin/|build/(?:[\w.-]+/){0,4})"
    r"(?![\w-]*\.\w|(?:configure|bootstrap|build)\b)[\w-]+(?=\s|$)",
    re.MULTILINE,
)
"""A program that is started by its path, not a script."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each option once: ``value`` is its name."""
    if not repository.has("CMakeLists.txt"):
        return
    found = {mention.value: mention for mention in (*_of_ci(repository), *_of_pages(repository))}
    off = _off(repository, found) if found else frozenset[str]()
    yield from (mention for name, mention in found.items() if name in off)


def _of_pages(repository: Repository) -> Iterator[Mention]:
    for page in pages(repository):
        text = repository.read(page)
        if "/" in page.path or page.size > MAX_SIZE or "ON" not in text:
            continue
        text = _FENCE.sub(lambda match: "\n" * match[0].count("\n"), text)
        for paragraph in _BLANK.split(text):
            if len(paragraph) <= MAX_PARAGRAPH and _PROGRAMS.search(paragraph):
                for match in _SET.finditer(paragraph):
                    at = text.count("\n", 0, text.find(paragraph)) + 1 + paragraph.count("\n", 0, match.start())
                    yield _mention(match[1], "readme", page.path, at, match[0])


def _of_ci(repository: Repository) -> Iterator[Mention]:
    """Yield the options with which a step configures the tree, where a later line starts a program by its path."""
    from roslab.evidence.lex.yaml import scalars  # noqa: PLC0415 - many trees have no CI

    for path in ci.files(repository):
        text = repository.read(path)
        if "cmake" not in text or "-D" not in text:
            continue
        given: list[Mention] = []
        for value in scalars(text) or ():
            shell = value.text.replace("\\\n", "  ")
            if given and _STARTS.search(shell):
                yield from given
                given = []
            if not _ELSEWHERE.search(shell):
                for call in _CONFIGURE.finditer(shell):
                    given += [_mention(name, "ci", path, value.line, call[0]) for name in _ON.findall(call[0])]


def _mention(name: str, source: Literal["readme", "ci"], path: str, line: int, text: str) -> Mention:
    return Mention(topic="asked_option", value=name, source=source, file=path, line=line, text=text.strip()[:200])


def _off(repository: Repository, names: Iterable[str]) -> frozenset[str]:
    """Return those of the names that a file of the tree declares as an option which is off."""
    declared = re.compile(rf"\boption[ \t]*\(\s*({'|'.join(map(re.escape, names))})\b([^()]{{0,400}})\)", re.IGNORECASE)
    files = (*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake"))[:MAX_FILES]
    found: dict[str, bool] = {}
    for file in files:
        if not places.vendored(file.path) and file.size <= MAX_SIZE:
            for match in declared.finditer(repository.read(file)):
                on = match[2].split()[-1:] in (["ON"], ["TRUE"], ["1"], ["YES"])
                found.setdefault(match[1], not on)
    return frozenset(name for name, off in found.items() if off)
