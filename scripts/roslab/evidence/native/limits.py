"""Signs in C++ code and in CMake files of the versions of compilers and libraries that the code compiles with."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from functools import cache

from roslab.evidence import places
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.lex.cmake import calls
from roslab.evidence.lex.lines import lines_with, matching_lines
from roslab.evidence.lex.truth import cmake_holds
from roslab.evidence.native import cmake_since
from roslab.evidence.native.has_include import HAS_INCLUDE, asked_for
from roslab.evidence.native.unlisted import Unlisted
from roslab.knowledge.code_limits import Limit, Sign, limits
from roslab.knowledge.hints import Search
from roslab.knowledge.kept_names import kept_names
from roslab.repository.checkout import Repository
from roslab.values.dataclass import dataclass, field, replace
from roslab.values.pattern import pattern

_STANDARD = pattern(
    r"^[^#\n]*?(?:\bCMAKE_CXX_STANDARD[ \t]+|-std=(?:c|gnu)\+\+|\bcxx_std_|\bCXX_STANDARD[ \t]+)(\d\w)\b", re.MULTILINE
)
_OPTION = pattern(r"-std=(?:c|gnu)\+\+(\w{2})(?!\w)")
_OF_OPTIONS = frozenset({"add_compile_options", "add_definitions", "target_compile_options"})
_ADDING = frozenset({"list", "string"})
_OF_FLAGS = _ADDING | {"set"}
_WAYS = (("APPEND",), ("PREPEND",))
"""What they do with an option that the compiler gets then: others replace or remove it."""
_DIRECTIVE = pattern(r"#[ \t]*(if|ifdef|ifndef|endif)\b[ \t]*([^\s(]*)")
"""It begins with a letter of its own, which is found much faster than the beginning of a line."""
_GUARDS = {"_VERSION": {"CV_VERSION": "OpenCV", "CV_MAJOR_VERSION": "OpenCV", "CERES_VERSION": "Ceres"}}
"""The file chooses by what is there, of a library; by what the words share, which is looked for first."""
_OLD_NAMES = ("imgproc/types_c.h", "constants_c.h")
"""Headers with the dropped names, as a file includes them that chooses by what is there."""
CUDA = (".cu", ".cuh")
HEADERS = (".h", ".hpp", ".hh", ".cuh")

MAX_PLACES = 100
"""Most files that are kept for a sign."""


@cache
def _signs(where: Sign, value: str) -> tuple[Limit, ...]:
    """Return the signs that a header or a standard is; few of them are named in thousands of files."""
    return tuple(limit for limit in _search(where).possible(value) if limit.pattern.search(value))


@cache
def _of_header(name: str) -> tuple[str, str, tuple[Limit, ...], tuple[Limit, ...]]:
    """Return the last part of a header, what is kept for it, and of which signs of old and of newer libraries it is."""
    last = name.rpartition("/")[2]
    return last, name if name in kept_names() else last, _signs("include", name), _signs("cpp11", name)


def tells(header: str) -> bool:
    """Tell whether a header is a sign, or keeps names: of another one it matters once that a file includes it."""
    return bool(_signs("include", header) or _signs("cpp11", header)) or header in kept_names()


@cache
def _search(where: Sign) -> Search[Limit]:
    return Search(limit for limit in limits() if limit.where == where)


@dataclass
class Signs:
    """The signs that were found so far, each with its places."""

    found: dict[tuple[str, str], list[tuple[str, CodeLimit]]] = field(default_factory=dict)
    """Each with the name of C++ or the command of CMake that it is, empty for others."""
    defined: set[str] = field(default_factory=set)
    """The names that the code defines itself, which it then does not need of a library."""
    commands: set[str] = field(default_factory=set)
    """The commands of CMake among the signs."""
    included: set[str] = field(default_factory=set)
    """The last parts of the headers that any file includes."""
    includes: dict[str, set[str]] = field(default_factory=dict)
    """What each file includes: headers by their last parts, and those that bring dropped names whole."""
    by_cuda: set[str] = field(default_factory=set)
    """The last parts of the headers that files of CUDA include."""
    newer: list[tuple[Limit, str, int]] = field(default_factory=list)
    """The headers that newer libraries refuse to C++11, each with its place."""
    reached: frozenset[str] | None = None
    """The last parts of the headers that a compiled source reaches, once somebody asked."""
    guarded: set[str] = field(default_factory=set)
    """The libraries for whose version a file of the tree asks: their names tell nothing."""

    def source(self, path: str, text: str) -> None:
        """Read a C++ file."""
        self.guarded.update(_guarded(text))
        for limit in _search("name").possible(text):
            names: dict[str, int] = {}
            for match in limit.pattern.finditer(text):
                before = text[text.rfind("\n", 0, match.start()) + 1 : match.start()]
                if before.lstrip(" \t#").startswith("define") and not before.partition("define")[2].strip():
                    self.defined.add(match[0])
                elif match[0] not in names and not (_comment(before) or _in_block(text, match.start())):
                    names[match[0]] = match.start()
            for name, start in names.items():
                if not conditional(text, start):
                    self._add(limit, path, text.count("\n", 0, start) + 1, name)

    def header(self, name: str, path: str, text: str, position: int) -> None:
        """Read an include at a position of a file."""
        last, brings, old, newer = _of_header(name)
        (self.by_cuda if path.endswith(CUDA) else self.included).add(last)
        self.includes.setdefault(path, set()).add(brings)
        if name.endswith(_OLD_NAMES):
            self.guarded.add("OpenCV")
        if not (old or newer) or conditional(text, position):
            return
        line = text.count("\n", 0, position) + 1
        for limit in old:
            self._add(limit, path, line)
        self.newer += ((limit, path, line) for limit in newer)

    def all(self, repository: Repository) -> tuple[CodeLimit, ...]:
        """Return the signs of the sources that were read and of the CMake files, each at its first place.

        A header that nothing includes is not compiled: a library that was copied whole has many. Nor is a source that
        no list has. What CUDA's compiler alone sees comes after what C++ has.
        """
        for key in [key for key in self.found if key[0] in self.guarded]:
            del self.found[key]
        for file in repository.named("CMakeLists.txt"):
            if not places.aside(file.path):
                text = repository.read(file)
                for match in matching_lines(_STANDARD, text, "CXX_STANDARD", "-std=", "cxx_std_"):
                    for sign in _signs("standard", match[1]):
                        self._add(sign, file.path, text.count("\n", 0, match.start(1)) + 1)
                if "-std=" in text:
                    self._options(file.path, text)
                for sign in _search("cmake").possible(text):
                    self._command(sign, file.path, text)
        if self.commands:
            self.defined |= self.commands & cmake_since.defined(repository)
        self._as_cpp11(repository)
        kept = {header: self._including(header) for header in kept_names()}
        unlisted = Unlisted(repository)
        packages = tuple(f"{file.folder}/" for file in repository.named("package.xml") if file.folder)
        places_of = (sorted(each, key=lambda p: not p[1].file.startswith(packages)) for each in self.found.values())
        first = (next((limit for limit in self._meant(each, kept, unlisted)), None) for each in places_of)
        return tuple(limit for limit in first if limit)

    def _options(self, path: str, text: str) -> None:
        """Read the names of standards in options that every machine's compiler gets: one may not know such a name."""
        if not any(_signs("option", match[1]) for match in _OPTION.finditer(text)):
            return
        for call in calls(text, _OF_OPTIONS | _OF_FLAGS):
            words = " ".join(call.words)
            adds = call.name not in _ADDING or call.words[:1] in _WAYS
            named = call.name in _OF_OPTIONS or (adds and "CXX" in words)
            always = not call.in_function and all(map(_always, call.conditions))
            if named and always and (found := _OPTION.search(words)):
                for sign in _signs("option", found[1]):
                    self._add(sign, path, call.line)

    def _command(self, sign: Limit, path: str, text: str) -> None:
        """Read the calls of a command of CMake that are made on every machine."""
        for call in calls(text, frozenset(sign.hints.each)):
            if sign.pattern.search(call.name) and not call.in_function and all(map(_always, call.conditions)):
                self.commands.add(call.name)
                self._add(sign, path, call.line, call.name)

    def _as_cpp11(self, repository: Repository) -> None:
        """Add the headers that a newer library refuses to the standard of their files."""
        packages = frozenset(file.folder for file in repository.named("package.xml"))
        for library in dict.fromkeys(limit.library for limit, _, _ in self.newer):
            from roslab.evidence.native import old_standard  # noqa: PLC0415 - few trees use what a newer library refuses

            standards = old_standard.read(repository, library)
            for limit, path, line in self.newer:
                if limit.library == library and old_standard.is_old(path, standards, packages):
                    self._add(limit, path, line)

    def _meant(
        self, found: Iterable[tuple[str, CodeLimit]], kept: Mapping[str, AbstractSet[str]], unlisted: Unlisted
    ) -> Iterator[CodeLimit]:
        """Yield the places of a sign where it is one of a library's version, those of C++ first.

        The code defines no such name itself, no header keeps it, and the file is compiled.
        """
        for cuda in (False, True):
            for name, limit in found:
                if name in self.defined or self._of_cuda(limit.file) is not cuda:
                    continue
                brought = any(
                    limit.file in kept[header] and names.match(name) for header, names in kept_names().items()
                )
                if not brought and self._compiled(limit.file, unlisted):
                    yield replace(limit, cuda=cuda)

    def _of_cuda(self, file: str) -> bool:
        """Tell whether CUDA's compiler alone sees a file: one of its own, or a header that only those include."""
        name = file.rpartition("/")[2]
        return file.endswith(CUDA) or (name.endswith(HEADERS) and name in self.by_cuda - self.included)

    def _including(self, header: str) -> set[str]:
        """Return the files that include a header, themselves or by headers of the tree."""
        found = {path for path, names in self.includes.items() if header in names}
        last: set[str] = set()
        while found and (new := {path.rpartition("/")[2] for path in found}) != last:
            last = new
            found |= {path for path, names in self.includes.items() if names & last}
        return found

    def _compiled(self, file: str, unlisted: Unlisted) -> bool:
        name = file.rpartition("/")[2]
        if name.endswith(HEADERS):
            return name in self.reached_by(unlisted)
        return name in self.included or name in self.by_cuda or not unlisted.has(file)

    def reached_by(self, unlisted: Unlisted) -> frozenset[str]:
        """Return the last parts of the headers that a compiled source includes, itself or by other headers.

        A library of headers alone has no source: what another one of them includes is for whoever compiles with it.
        """
        if self.reached is None:
            sources = [path for path in self.includes if not path.endswith(HEADERS)]
            new = {path for path in sources if not unlisted.has(path)} if sources else set(self.includes)
            self.reached = frozenset(reached(new, self.includes))
        return self.reached

    def _add(self, sign: Limit, file: str, line: int, name: str = "") -> None:
        found = CodeLimit(
            library=sign.library, at_least=sign.at_least, below=sign.below, what=sign.what, file=file, line=line
        )
        known = self.found.setdefault((sign.library, sign.what), [])
        if all((name, file) != (other, limit.file) for other, limit in known[-1:]) and len(known) < MAX_PLACES:
            known.append((name, found))


def reached(paths: AbstractSet[str], includes: Mapping[str, AbstractSet[str]]) -> set[str]:
    """Return the last parts of the headers that files include, themselves or by headers of that name in the tree."""
    named: dict[str, list[str]] = {}
    for path in includes:
        named.setdefault(path.rpartition("/")[2], []).append(path)
    found: set[str] = set()
    new = set(paths)
    while new:
        names = {name.rpartition("/")[2] for path in new for name in includes[path]} - found
        found |= names
        new = {path for name in names for path in named.get(name, ())}
    return found


def _guarded(text: str) -> Iterator[str]:
    for shared, words in _GUARDS.items():
        if shared in text:
            yield from (library for word, library in words.items() if _directed(text, word))
    if HAS_INCLUDE in text and _directed(text, HAS_INCLUDE):
        yield from asked_for(text)


def _directed(text: str, word: str) -> bool:
    """Tell whether a word stands in a directive: what only prints a version chooses nothing by it."""
    starts = lines_with(text, word)
    return any(text[start : start + 80].lstrip().startswith("#") or text.endswith("\\\n", 0, start) for start in starts)


def conditional(text: str, position: int) -> bool:
    """Tell whether a place is compiled under a condition only, other than the guard of the header itself.

    ``#ifdef __cplusplus`` is none either; a comparison of it asks for a standard that the compiler need not have.
    """
    open_: list[bool] = []
    for match in _DIRECTIVE.finditer(text, 0, position):
        kind, name = match[1], match[2]
        if text[text.rfind("\n", 0, match.start()) + 1 : match.start()].strip(" \t"):
            continue
        if kind == "endif":
            del open_[-1:]
        elif kind.startswith("if"):
            guard = kind == "ifndef" and text[match.end() :].lstrip().startswith(f"#define {name}")
            open_.append(not guard and (name != "__cplusplus" or kind == "if"))
    return any(open_)


def _always(condition: str) -> bool:
    return bool(cmake_holds(condition, lambda _: False))


def _comment(before: str) -> bool:
    """Tell it from what stands before a name on its line."""
    return "//" in before or before.lstrip().startswith("*")


def _in_block(text: str, position: int) -> bool:
    """Tell whether a comment of several lines is open there; what only looks like one is in a string."""
    return text.rfind("/*", 0, position) > text.rfind("*/", 0, position)
