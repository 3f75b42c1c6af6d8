"""Folders of the author's own computer in CMake files: what the build takes from them is in no image."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.evidence import places
from roslab.evidence.lex.cmake import EVERY, calls
from roslab.evidence.native.authors_parts import LIBRARY
from roslab.repository.checkout import Repository, nearest
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

MAX_FILES = 300
"""Most CMake files that are searched, those nearest to the root first."""
MAX_SIZE = 64 * 1024
MAX_CODE = 3_000
"""Most files of code that are searched for the macros, those nearest to the root first."""
MAX_CODE_SIZE = 512 * 1024
_PATH = r"(/(?:home|Users)/[A-Za-z][\w.-]*/[\w./+-]*)"
_HOME = pattern(rf"(?<![\w/}}]){_PATH}")
_DEFINING = frozenset({"target_compile_definitions", "add_compile_definitions", "add_definitions"})
_DEFINED = pattern(rf"(?:-D|(?<![\w-]))([A-Za-z_]\w*)=[\\\"']*{_PATH}")
_REMARK = pattern(r"//[^\n]*")
_WORD = pattern(r"[A-Za-z_]\w*")
_CODE = (".c", ".cc", ".cpp", ".cxx", ".cu", ".h", ".hh", ".hpp", ".hxx", ".cuh", ".in")
_TAKEN = "what the build takes from there is not in the image; put it under `source` in roslab.yaml"
_READ = (
    "the code has it as {}, and what it reads there when it runs is not in the image; mount it, or write a path of the "
    "tree"
)


@dataclass(frozen=True, kw_only=True, slots=True)
class _Place:
    """Such a folder in a file of CMake, with the macro that it is defined as there, if any."""

    path: str
    file: str
    line: int
    macro: str


def read(repository: Repository, meant: Collection[tuple[str, int]] = ()) -> Iterator[tuple[str, str, int]]:
    """Yield what the author should know of the first such folder: the message, the file and the line.

    ``meant``: files and lines that name what the tree has, to which a link leads.
    """
    files = (f for f in repository.named("CMakeLists.txt") if f.size <= MAX_SIZE and not places.vendored(f.path))
    kept = [f for f in files if not places.test(f.path) and not places.example(f.path)]
    texts = ((file.path, repository.read(file)) for file in nearest(kept)[:MAX_FILES])
    found = [place for path, text in texts for place in _places(path, text) if (path, place.line) not in meant]
    used = _used({place.macro for place in found} - {""}, repository)
    told = {(place.file, place.line): place for place in reversed(found) if not place.macro or place.macro in used}
    if told:
        *others, first = told.values()
        more = f", and so are {len(others)} more" if len(others) > 1 else ", and so is one more" if others else ""
        why = _READ.format(first.macro) if first.macro else _TAKEN
        what = "file" if LIBRARY.fullmatch(first.path) else "folder"
        yield f"{first.path} is a {what} of its author's computer{more}: {why}", first.file, first.line


def _places(file: str, text: str) -> Iterator[_Place]:
    """Yield the folders in a file of CMake, each where it stands."""
    if "/home/" not in text and "/Users/" not in text:
        return
    defining = {call.line: call.name in _DEFINING for call in calls(text, EVERY)}
    defines = False
    for number, line in enumerate(text.split("\n"), 1):
        defines = defining.get(number, defines)
        code = line.partition("#")[0]
        macros = {match.start(2): match[1] for match in _DEFINED.finditer(code)} if defines else {}
        for match in _HOME.finditer(code):
            yield _Place(path=match[1], file=file, line=number, macro=macros.get(match.start(1), ""))


def _used(macros: Collection[str], repository: Repository) -> set[str]:
    """Return those of the macros that code of the tree names outside of a comment of one line."""
    left, used = set(macros), set[str]()
    files = (file for file in repository.suffixed(*_CODE) if file.size <= MAX_CODE_SIZE) if left else ()
    for file in nearest(files)[:MAX_CODE]:
        if not left:
            break
        here = left.intersection(_WORD.findall(_REMARK.sub("", repository.read(file))))
        used |= here
        left -= here
    return used
