"""Python packages that a page lists or names with a version, without a command that installs them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from roslab.evidence.prose.limits_in_sentences import MAX_LINE, MAX_PARAGRAPH, MEANT, NOT, SENTENCE, bounded, fence
from roslab.evidence.prose.pages import pages, text_of
from roslab.evidence.prose.said_releases import release_of
from roslab.knowledge.prose_names import package_of, said_names
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

_TITLE = pattern(
    r"\b(?:requirements?|required|dependenc(?:y|ies)|prerequisites?|pre-requisites?|environments?|packages)\b",
    re.IGNORECASE,
)
"""The heading, or the line that ends in a colon, above a list of what is needed."""
_HEADING = pattern(r"^\s{0,3}#{1,6}\s+(.*?)\s*#*$")
_UNDERLINE = pattern(r"^\s{0,3}([=~^\"'`+#*-])\1{3,}\s*$")
_BOLD = pattern(r"^\s{0,3}(\*\*|__)([^*_]{1,60})\1[\s:]*$")
"""A line that is all in bold: a title to its reader."""
MAX_CELL = 80
"""Most letters of a cell that names a package or its version."""
_NUMBER = pattern(r"(?:[=<>~]{0,2}|≥|v\.?|version)\s*\d{1,2}(?:\.\d{1,3}){1,2}(?:\.x|\+)?", re.IGNORECASE)
_SYSTEM = pattern(
    r"(?:a\s+)?(?:python|cuda|cudnn|ubuntu|linux|gcc|g\+\+|cmake|nvidia|gpu|ros|conda|miniconda|anaconda|macos|windows)\b"
    r"(?:\.\d|[^.,:;]){0,40}",
    re.IGNORECASE,
)
"""What a list of packages has beside these."""
_ITEM = pattern(r"^\s{0,8}(?:[-*+]|\d{1,2}[.)])\s+(.*)$")
_MARKUP = pattern(r"[*`]{1,3}|(?<!\w)_{1,3}|_{1,3}(?!\w)|\[([^\[\]\n]{1,80})\]\([^()\s]{0,300}\)")
_OF_BRANCH = pattern(r"\]\([^()\s]{1,300}\)[\s*`_]{0,4}={1,2}[\s*`_]{0,4}(?!v\d)[A-Za-z]")
"""A link with a branch or a commit behind it, and no version: its repository is meant, no package of the index."""
_NAMED = pattern(
    r"^\W{0,8}(?:\w+\s+){0,2}(?:requirements?|dependenc(?:y|ies)|prerequisites?|(packages|libraries|modules))\s{0,3}:\s+"
    r"(\S.*)$",
    re.IGNORECASE,
)
"""A line that lists what is needed itself: "Known dependencies: Python (3.5.4), numpy (1.14.5)"."""
_TRIED = r"(?:(?:tested|works?|developed)\s+(?:with|on|using|for|under)\s+)?"
_VERSION = (
    _TRIED + r"(?:version\s*|v\.?\s*)?(==|>=|<=|~=|=|≥|<|>|-|:)?\s*(?:version\s*|v\.?\s*)?(\d{1,2}(?:\.\d{1,3}){1,2})"
)
_MORE = r"(\.x|\+|\s*(?:or|and)\s+(?:newer|later|above|higher|greater|up))?"
_LISTED = pattern(
    rf"^([A-Za-z][\w.-]*?(?:\s[A-Za-z][\w-]+)?)[\s(]*(?:{_VERSION}{_MORE})?(?=$|[\s),.;:])", re.IGNORECASE
)
_BY_PIP = pattern(
    r"^(?![\s>|#]).*\binstall\b.*\b(?:with|using|by|via|through)\s+[`*_(\"]*pip3?\b[^.]*:\s*$", re.IGNORECASE
)
"""A line above a block of requirements: "Install the following (with `pip install`):"."""
_LINE = pattern(
    r"^(['\"]?)[A-Za-z][\w.-]*(?:\[[\w,-]+\])?(?:\s?(?:[<>=!~]=|[<>])\s?[\d.*]+(?:,\s?(?:[<>=!~]=|[<>])\s?[\d.*]+)*)?\1$"
)
_EXACT = pattern(
    r"^([A-Za-z][\w.-]*(?:\[[\w,-]+\])?)(\s?(?:[<>=!~]=|[<>])\s?\d[\d.*]*(?:,\s?(?:[<>=!~]=|[<>])\s?\d[\d.*]*)*)$"
)
_PYTHON = pattern(r"\b(?:python|pip)\b", re.IGNORECASE)
_PARTS = pattern(r",\s*(?:and\s+)?|\s+and\s+|\s*;\s*|\s+/\s+")
_REQUIRED = pattern(r"^[A-Za-z][\w.-]*(?:\[[\w,-]+\])?(?:\s?(?:[<>=!~]?=|[<>])\s?\d[\w.*]*)?$")
"""A package with or without a version; conda writes one ``=``."""
_REMARK = pattern(r"\s+[%#].*$")
FEWEST = 2
"""Fewest names of a list in one line."""
_AT_LEAST = frozenset({">=", "≥", ">"})


class _Line(NamedTuple):
    """A line of a page outside of its blocks, or of a block that lists what is needed."""

    number: int
    text: str
    item: str | None
    """The item of a list below a title such as "Requirements" that it is."""
    titled: bool
    """It stands below such a title."""
    of_python: bool
    """The title names Python."""


def read(repository: Repository) -> tuple[Requirement, ...]:
    """Return what the pages at the root list or name with a version, each once."""
    found = (file for file in pages(repository) if "/" not in file.path)
    texts = tuple((text_of(repository, file), file.path) for file in found)
    return tuple(dict.fromkeys(asked for page in texts for asked in (*blocks(*page), *said(*page), *bounded(*page))))


def blocks(text: str, file: str) -> Iterator[Requirement]:
    """Yield the lines of a block that pip is to be given, where each of them is a requirement and nothing else."""
    lines = text.split("\n")
    for number, line in enumerate(lines, start=1):
        if len(line) > MAX_LINE or not _BY_PIP.match(line):
            continue
        block = list(_block(lines, number))
        if block and all(len(words) <= MAX_LINE and _LINE.match(words) for _, words in block):
            yield from (stated(words.strip("'\""), "prose", file, at) for at, words in block)


def _block(lines: list[str], number: int) -> Iterator[tuple[int, str]]:
    """Yield the lines of the code block that begins below a line, with their numbers."""
    while number < len(lines) and not lines[number].strip():
        number += 1
    fenced = number < len(lines) and fence(lines[number])
    for at, line in enumerate(lines[number + fenced :], start=number + fenced + 1):
        if fence(line) or not (fenced or not line.strip() or line.startswith(("    ", "\t"))):
            return
        if line.strip():
            yield at, line.strip()


def said(text: str, file: str) -> Iterator[Requirement]:
    """Yield each package that a list below a title such as "Requirements" names, and each framework with a version.

    Only names that the tables know count: a list may name compilers and devices as well. One below a title that says
    that it is for Python has no others where they are written as pip is given them, with a version.
    """
    for line in _lines(text):
        if line.item is not None:
            written = list(_written(line.item, file, line.number, of_python=line.of_python))
            yield from written or _listed(line.item[:MAX_LINE], file, line.number)
            continue
        plain = _plain(line.text)
        if line.titled and (found := tuple(_row(plain, file, line.number) or _whole(plain, file, line.number))):
            yield from found
            continue
        for sentence in SENTENCE.split(plain):
            listed = _NAMED.match(sentence[:MAX_LINE])
            if listed and (line.titled or not listed[1]):
                yield from _listed(listed[2], file, line.number)
            elif len(sentence) <= MAX_LINE and MEANT.search(sentence) and not NOT.search(sentence):
                for match in _said().finditer(sentence):
                    yield from _asked(match[1], match, file, line.number)


def _row(plain: str, file: str, number: int) -> tuple[Requirement, ...]:
    """Return the package of a row of a table with a version in its second cell."""
    name, version, *_ = (*map(str.strip, plain.strip().removeprefix("|").split("|")), "", "")
    fits = 0 < len(name) <= MAX_CELL and len(version) <= MAX_CELL and _NUMBER.fullmatch(version)
    return tuple(_listed(f"{name} {version}", file, number)) if fits else ()


def _whole(plain: str, file: str, number: int) -> tuple[Requirement, ...]:
    """Return the packages of a line that lists some and the system they run on, and says nothing else."""
    parts = [part.strip() for part in _PARTS.split(plain.strip().rstrip("."))] if len(plain) <= MAX_LINE else []
    if len(parts) < FEWEST:
        return ()
    found = [tuple(_listed(part, file, number)) for part in parts if not _SYSTEM.fullmatch(part)]
    fits = all(found) and all(_LISTED.fullmatch(part) or _SYSTEM.fullmatch(part) for part in parts)
    return tuple(each for part in found for each in part) if fits else ()


def items(text: str) -> Iterator[tuple[int, str]]:
    """Yield the items of lists below a title such as "Requirements", with their lines."""
    return ((line.number, line.item[:MAX_LINE]) for line in _lines(text) if line.item is not None)


def _written(item: str, file: str, line: int, *, of_python: bool) -> Iterator[Requirement]:
    """Yield the package of an item that is a requirement with a version and nothing else: ``commonroad-io>=2022.1``."""
    if (match := _EXACT.match(item.strip())) and match[1].lower() != "python":
        package = package_of(match[1]) or (match[1] if of_python else None)
        if package:
            yield stated(f"{package}{match[2]}".replace(" ", ""), "prose", file, line, role="listed")


def _lines(text: str) -> Iterator[_Line]:
    """Yield the lines of a page outside of its blocks; of a block below such a title, those of packages, as items."""
    titled = fenced = of_python = by_bold = False
    lines = text.split("\n")
    for number, line in enumerate(lines, start=1):
        if fence(line):
            fenced = not fenced
            if fenced and titled:
                yield from (_Line(at, words, words, titled, of_python) for at, words in _of_block(lines, number - 1))
        if fenced or not line.strip() or len(line) > MAX_PARAGRAPH:
            continue
        below = lines[number] if number < len(lines) else ""
        item = _ITEM.match(line)
        bold = _BOLD.match(line)
        if (heading := _HEADING.match(line)) or bold or _UNDERLINE.match(below):
            title = heading[1] if heading else bold[2] if bold else line
            if _TITLE.search(title) or by_bold or not bold:  # below a heading it may be an item, or part the list
                titled, of_python, by_bold = bool(_TITLE.search(title)), bool(_PYTHON.search(title)), bool(bold)
        elif item is None and not line.startswith((" ", "\t")) and _plain(line).rstrip().endswith(":"):
            titled, of_python = bool(_TITLE.search(line)), bool(_PYTHON.search(line))
        named = item and titled and not _OF_BRANCH.search(line)
        words = _plain(item[1][:MAX_LINE]) if item and named else None
        yield _Line(number, line, words, titled and not (heading or bold), of_python)


def _of_block(lines: list[str], number: int) -> tuple[tuple[int, str], ...]:
    """Return the lines of a block that begins with this line, if each is a requirement, and some are of packages."""
    block = list(_block(lines, number))
    if any(len(words) > MAX_LINE for _, words in block):
        return ()
    found = [(at, _REMARK.sub("", words)) for at, words in block]
    if not all(_REQUIRED.match(words) or _SYSTEM.fullmatch(words) for _, words in found):
        return ()
    packages = [(at, words) for at, words in found if not _SYSTEM.fullmatch(words)]
    return tuple(packages) if any(_EXACT.match(words) for _, words in packages) else ()


def _plain(words: str) -> str:
    return _MARKUP.sub(lambda match: match[1] or "", words)


def _listed(item: str, file: str, line: int) -> Iterator[Requirement]:
    """Yield the package of one item of a list, or those of several with commas between them."""
    for part in re.split(r",\s*|\s+and\s+|\s+/\s+", item)[:20]:
        match = _LISTED.match(part.strip())
        if match is None:
            return
        if match[1].lower() == "python":
            continue
        words = match[1].split()
        name = match[1] if package_of(match[1]) else words[0]
        if not package_of(name) or (name != match[1] and words[1:2] and not match[3]):
            return  # the rest of the item is a sentence
        yield from _asked(name, match, file, line)


@cache
def _said() -> re.Pattern[str]:
    """Return the pattern of a package's name with a version, in a sentence."""
    return pattern(rf"\b({said_names()})[\s(-]*{_VERSION}{_MORE}(?![\w.]*\d)", re.IGNORECASE)


def _asked(name: str, match: re.Match[str], file: str, line: int) -> Iterator[Requirement]:
    """Yield the requirement of a name with the version behind it, if there is such: ``PyTorch 1.8`` is any 1.8."""
    sign, number, more = match[2], match[3], match[4]
    package = package_of(name)
    if package is None or name.lower() == "python":
        return
    number = number and release_of(package, number, match.string, match.end())
    specifier = ""
    if number and (sign in _AT_LEAST or (more and more != ".x")):
        specifier = f">={number}"
    elif number and sign in {"<", "<="}:
        specifier = f"{sign}{number}"
    elif number:
        specifier = f"=={number}" if number.count(".") == 2 and more != ".x" else f"=={number}.*"
    yield stated(package + specifier, "prose", file, line, role="listed")
