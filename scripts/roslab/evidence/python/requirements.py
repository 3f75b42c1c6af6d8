"""Requirements files under any usual name."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from typing import Literal

from roslab.evidence import places
from roslab.evidence.facts import RequirementFile
from roslab.evidence.python import misspelt_lists
from roslab.evidence.python.misplaced_lists import with_misplaced
from roslab.evidence.python.raised import raised
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import requirement, stated

MAX_LINES = 3_000
"""Most requirement lines read of one file; a longer one is data."""
MAX_SIZE = 512 * 1024
Purpose = Literal["run", "docs", "test", "dev", "vendored"]
_NAME = pattern(
    r"^(?=(?:.*[-_.])?(?:no|non|not)[-_](?:apt|conda|rosdep|system|debian)|(?!.*(?:apt|conda|rosdep|system|constraint|debian)))"
    r"(?:.*[-_.])?(?:requirements?|requires)(?:[-_.\d].*)?\.(?:txt|in|pip)$"
)
_FOLDER = pattern(r"(?:^|/)requirements?$", re.IGNORECASE)
_DOCS = pattern(r"(?:^|[-_./])(?:docs?\d?|sphinx|mkdocs|documentation|rtd|readthedocs)(?:[-_./]|$)", re.IGNORECASE)
_TESTS = pattern(r"(?:^|[-_./])(?:tests?|testing|pytest)(?:[-_./]|$)", re.IGNORECASE)
_DEV = pattern(
    r"(?:^|[-_./])(?:dev|develop|development|lint|linter|format|ci|build|release|style|precommit|typing)(?:[-_./]|$)",
    re.IGNORECASE,
)
_OPTION = pattern(
    r"^(-i|--index-url|--extra-index-url|-f|--find-links|--pre|--trusted-host|--no-index|--no-binary|"
    r"--only-binary|--prefer-binary|--use-feature)\b[ =]*(.*)$"
)
_INDEX = pattern(r"(?:^|\s)(-i|--index-url|--extra-index-url|-f|--find-links)[ =]+(https?://\S+)")
"""An option that says where packages lie, wherever it stands in a line."""
_LONG = {"-i": "--index-url", "-f": "--find-links"}
_LISTS = (".txt", ".in", ".pip", ".list", ".req", ".reqs")
_NESTED = pattern(r"^(?:-r|--requirement)[ =]*(\S+)$")
_COMMENTED = pattern(r"^[ \t]*#[ \t]*(?:-r|--requirement)[ =]*(\S+)", re.MULTILINE)
_WORDS = pattern(r"\w[\w.-]*(?:\s*:|\s+[\w(:=<>].*|\s*[=<>~!][^/$]*)")
"""A line that is neither a path, nor an address, nor an option, nor the name of a package alone."""
_CONSTRAINT = pattern(r"^(?:-c|--constraint)[ =]*(\S+)$")


def read(repository: Repository, asked: Iterable[Requirement] = ()) -> tuple[RequirementFile, ...]:
    """Return every requirements file of the tree, and what they include, sorted by path.

    So are the files of any name that pages have pip read, which are ``asked`` for.
    """
    found: dict[str, RequirementFile] = {}
    pending = [
        file.path
        for file in repository.suffixed(".txt", ".in", ".pip")
        if _NAME.match(file.name.lower()) or (_FOLDER.search(file.folder) and file.name.endswith((".txt", ".in")))
    ]
    pending = [path for path in pending if ".egg-info" not in path]
    misspelt = misspelt_lists.named(repository).difference(pending)
    pending += misspelt
    pending += _given(repository, asked)
    while pending:
        path = pending.pop()
        if path in found or not repository.has(path):
            continue
        text = repository.read(path, limit=MAX_SIZE)
        file = with_misplaced(repository, parse(text, path, purpose_of(path)))
        if of_another_tool(text, file) or (
            path in misspelt and not misspelt_lists.only_packages(file, len(_lines(text)))
        ):
            continue
        there = tuple(constraint for constraint in file.constraints if repository.has(constraint))
        found[path] = replace(file, constraints=there, raised=raised(repository, path, file.requirements))
        pending += found[path].includes
    included = {path for file in found.values() for path in file.includes}
    aside = {path for file in found.values() for path in _left_out(repository, file)} - included
    return tuple(
        replace(found[path], purpose="dev") if path in aside and found[path].purpose == "run" else found[path]
        for path in sorted(found)
    )


def _given(repository: Repository, asked: Iterable[Requirement]) -> list[str]:
    """Return the files that pages give to ``pip install -r``, as far as the tree has one of that path."""
    paths = {each.written.removeprefix("./") for each in asked if each.role == "file" and each.written}
    found = []
    for path in sorted(path for path in paths if path.endswith(_LISTS) or "." not in path.rpartition("/")[2]):
        files = repository.named(path.rpartition("/")[2])
        there = [file.path for file in files if f"/{file.path}".endswith(f"/{path}")]
        # From above the repository its own folder stands before the path
        below = [file.path for file in files if path.endswith(f"/{file.path}")]
        found += there or below
    return found


def _left_out(repository: Repository, file: RequirementFile) -> list[str]:
    """Return the files that a file includes in comments alone: only who needs them installs them."""
    lines = _COMMENTED.findall(repository.read(file.file, limit=MAX_SIZE)) if file.includes else []
    return [_inside(file.file.rpartition("/")[0], line) for line in lines]


def purpose_of(path: str) -> Purpose:
    """Tell from a path what a requirements file is for."""
    if places.vendored(path):
        return "vendored"
    name = path.rpartition("/")[2]
    if _DOCS.search(path):
        return "docs"
    if _TESTS.search(name) or places.test(path):
        return "test"
    return "dev" if _DEV.search(name.rpartition(".")[0]) else "run"


def parse(text: str, path: str, purpose: Purpose) -> RequirementFile:
    """Parse one file's text. A line that pip would refuse is repaired if its meaning is clear.

    Of a list that conda wrote, only what pip had installed is pip's.
    """
    from roslab.evidence.python import conda_list  # noqa: PLC0415 - few trees have a list of requirements

    found: list[Requirement] = []
    includes: list[tuple[str, int]] = []
    constraints: list[str] = []
    options: list[str] = []
    unread: list[int] = []
    folder = path.rpartition("/")[0]
    of_conda = conda_list.exported(text)
    for number, line in _lines(text):
        if of_conda:
            found += [replace(stated(each, "manifest", path, number), role="repaired") for each in _by_pip(line)]
        elif nested := _NESTED.match(line):
            if include := _inside(folder, nested[1]):
                includes.append((include, number))
        elif constraint := _CONSTRAINT.match(line):
            constraints.append(_inside(folder, constraint[1]))
        elif option := _OPTION.match(line):
            options.append(f"{_LONG.get(option[1], option[1])} {option[2].strip()}".strip())
        elif asked := requirement(line, "manifest", path, number):
            found.append(asked)
        else:
            several, given = _several(line, path, number)
            found += several
            options += given
            unread += [number] if not (several or given) and _WORDS.fullmatch(line) else []
    return RequirementFile(
        file=path,
        line=1,
        requirements=tuple(found),
        includes=tuple(include for include, _ in includes),
        include_lines=tuple(line for _, line in includes),
        constraints=tuple(constraint for constraint in constraints if constraint),
        options=tuple(dict.fromkeys(options)),
        purpose=purpose,
        unread=tuple(unread),
    )


def _by_pip(line: str) -> list[str]:
    """Return what pip had installed of a line in a list that conda wrote, which may hold a line of pip's own."""
    from roslab.evidence.python import conda_list  # noqa: PLC0415 - as above

    return [line] if "==" in line else [each for each in [conda_list.of_pip(line)] if each]


def of_another_tool(text: str, file: RequirementFile) -> bool:
    """Tell whether pip can read no line of a file: one of cget for C++, say, lists ``owner/name@tag`` under this name.

    https://pip.pypa.io/en/stable/reference/requirements-file-format/, read 2026-11-26. An empty file is pip's.
    """
    read = file.requirements or file.includes or file.constraints or file.options
    return not read and any(not line.startswith("-") for _, line in _lines(text))


def _several(line: str, path: str, number: int) -> tuple[list[Requirement], list[str]]:
    """Return the packages and options of a line written like the words after ``pip install``; none of any other line.

    pip reads one requirement a line, and knows ``-f`` and the like only on lines of their own:
    https://pip.pypa.io/en/stable/reference/requirements-file-format/, read 2026-11-22.
    """
    options = [f"{_LONG.get(found[1], found[1])} {found[2]}" for found in _INDEX.finditer(line)]
    words = _INDEX.sub(" ", line).split()
    asked = [requirement(word, "manifest", path, number, repair=False) for word in words]
    read = all(each and not each.role for each in asked)
    if not words or not read or not (options or any(each and each.specifier for each in asked)):
        return [], []  # a sentence is words too
    return [replace(each, role="repaired") for each in asked if each], options


def _lines(text: str) -> list[tuple[int, str]]:
    """Return the lines that pip would read: without comments, continuations joined."""
    lines: list[tuple[int, str]] = []
    pending, start = "", 0
    for number, raw in enumerate(text.split("\n", MAX_LINES)[:MAX_LINES], 1):
        line = re.sub(r"(?:^|\s)#.*$", "", raw[:2000]).strip()
        start = start if pending else number
        if line.endswith("\\"):
            pending += line[:-1].rstrip() + " "
            continue
        if line := (pending + line).strip():
            lines.append((start, line))
        pending = ""
    return lines


def _inside(folder: str, path: str) -> str:
    """Return a path relative to the root, ``""`` where it leads out of the tree."""
    joined = posixpath.normpath(posixpath.join(folder, path))
    return "" if joined.startswith(("..", "/")) or "://" in path else joined
