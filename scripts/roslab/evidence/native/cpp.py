"""C++ and CUDA sources: which external headers they include."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.dependency import Dependency, Strength
from roslab.evidence.lex.includes import includes
from roslab.evidence.native import x86
from roslab.evidence.native.generated import package_of
from roslab.evidence.native.limits import Signs, conditional, tells
from roslab.evidence.native.message_headers import MessageHeaders
from roslab.evidence.native.nowhere import Nowhere
from roslab.evidence.native.reached_code import without_unreached
from roslab.evidence.native.unincluded import unincluded
from roslab.evidence.native.where_found import where_found
from roslab.knowledge.libraries import library, only_missed
from roslab.knowledge.windows import opens
from roslab.knowledge.windows import shown as shown_by
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

SUFFIXES = (".cpp", ".hpp", ".h", ".cc", ".cxx", ".hh", ".c", ".cu", ".cuh")
COMPILED = (".cpp", ".cc", ".cxx", ".c", ".msg", ".srv", ".action", ".idl")
"""Of what is compiled: sources, and definitions of which code is made."""
MAX_READ = 64 * 1024
"""Bytes of a source file that are searched: includes are at its top, and few files are longer."""
MAX_SOURCES = 2_500
"""Most source files opened, those nearest to the root first."""
MAX_SIZE = 1024 * 1024
_ASKS = "__has_include"
_DIRECTIVE = pattern(r"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b([^\n]*)", re.MULTILINE)
_STANDARD = pattern(
    r"^(?:[a-z_]+|c[a-z]+|std\w+\.h|bits/.*|sys/.*|linux/.*|arpa/.*|netinet/.*|net/.*|experimental/.*|(?:math|string|time|errno|signal|unistd|assert|ctype|fcntl|float|limits|inttypes|poll|pthread|termios|dirent|getopt|memory|locale|dlfcn|x86intrin|immintrin|emmintrin|xmmintrin|malloc|sched|wchar|windows)\.h)$"
)


def read(
    repository: Repository,
    signs: Signs | None = None,
    intrinsics: x86.Intrinsics | None = None,
    nowhere: Nowhere | None = None,
) -> tuple[Dependency, ...]:
    """Return the included headers that neither the tree nor the compiler has, each once, at its first place.

    After them come the libraries that open windows by a call, and what sources use without its header.

    ``signs``, ``intrinsics`` and ``nowhere`` are shown every file, so that each is read once.
    """
    found: dict[str, Dependency] = {}
    opened: dict[str, Dependency] = {}
    outside: dict[str, bool] = {}
    inside: dict[str, bool] = {}
    settled: set[str] = set()
    """Headers of which another include tells nothing more: most are included by many files."""
    messages = MessageHeaders()
    sources = _sources(repository)
    for file in sources:
        text = repository.read(file, limit=MAX_READ)
        if signs:
            signs.source(file.path, text)
        _note_windows(file, text, opened)
        position, line = 0, 1
        for match in includes(text, settled):
            name = match[1]
            if signs:
                signs.header(name, file.path, text, match.start(1))
            if intrinsics:
                intrinsics.header(name, file.path, text, match.start())
            generated = bool(package_of(name))
            perhaps = generated and conditional(text, match.start())
            key = name if "/" not in name else "/".join(name.split("/")[:2])
            if name not in outside:
                inside[name] = not _standard(name) and _local(repository, name)
                outside[name] = not _standard(name) and not inside[name]
            _note_copied(repository, file, match, opened)
            lost = (
                (outside[name] or name.startswith(".")) and nowhere and nowhere.header(name, file, text, match.start())
            )
            perhaps = perhaps or (outside[name] and where_found(text, match.start(), name))
            told = key in found and (perhaps or found[key].strength != "optional")
            unsure = generated and key not in messages.certain
            settles = not (inside[name] or perhaps or lost or unsure) and (told or not outside[name])
            if settles and _is_settled(name, signs):
                settled.add(name)
            if (told and not unsure) or not outside[name] or _where_it_is(text, match.start()):
                continue
            if only_missed(name) and conditional(text, match.start()):
                continue
            line += text.count("\n", position, match.start(1))
            position = match.start(1)
            strength: Strength = "optional" if perhaps else "used"
            place = Dependency(namespace="include", name=name, strength=strength, file=file.path, line=line)
            messages.add(key, place)
            found[key] = place
    messages.settle(found, inside if len(sources) < MAX_SOURCES else None, repository)
    return (*found.values(), *opened.values(), *unincluded(repository, sources))


def _is_settled(name: str, signs: Signs | None) -> bool:
    """Tell whether a header that the tree does not have tells nothing where further files include it.

    One that only files of CUDA include so far may be one of C++ yet.
    """
    return not (tells(name) or x86.tells(name)) and (signs is None or name.rpartition("/")[2] in signs.included)


def _note_windows(file: File, text: str, opened: dict[str, Dependency]) -> None:
    """Note the libraries whose calls in a file open windows, each at its first place, and in each example."""
    for opener, place in shown_by(text, "c++").items():
        _note_window(file, opener, text.count("\n", 0, place) + 1, opened)


def _note_window(file: File, opener: str, line: int, opened: dict[str, Dependency]) -> None:
    example = places.example(file.path)
    role = "example" if example else "build"
    said = Dependency(namespace="call", name=opener, strength="used", file=file.path, line=line, role=role)
    opened.setdefault(f"{opener} {file.path}" if example else opener, said)


def _note_copied(repository: Repository, file: File, include: re.Match[str], opened: dict[str, Dependency]) -> None:
    """Note a library of windows that is copied into the tree: its header is there, and only in vendored code."""
    name = include[1]
    if not opens("include", name):
        return
    files = repository.by_name.get(name.rpartition("/")[2].lower(), ())
    ours = [each.path for each in files if f"/{each.path}".endswith(f"/{name}")]
    if ours and all(map(places.vendored, ours)):
        _note_window(file, name, include.string.count("\n", 0, include.start(1)) + 1, opened)


def _where_it_is(text: str, position: int) -> bool:
    """Tell whether an include is compiled only where its header, or another one, is there; ``#else`` is for others."""
    if text.find(_ASKS, 0, position) < 0:
        return False
    open_: list[bool] = []
    for match in _DIRECTIVE.finditer(text, 0, position):
        if match[1].startswith("if"):
            open_.append(_ASKS in match[2])
        elif match[1] == "endif":
            del open_[-1:]
        elif open_:
            open_[-1] = _ASKS in match[2]
    return any(open_)


def cuda_files(repository: Repository) -> tuple[str, ...]:
    """Return the CUDA sources of the tree, without vendored code."""
    return tuple(file.path for file in repository.suffixed(".cu") if not places.vendored(file.path))


def _standard(name: str) -> bool:
    """Tell whether the compiler has a header; some libraries name theirs like the standard does, ``<armadillo>``."""
    return bool(_STANDARD.match(name)) and library("include", name, None) is None


def _sources(repository: Repository) -> list[File]:
    files = [
        file
        for file in repository.suffixed(*SUFFIXES)
        if file.size < MAX_SIZE and not places.vendored(file.path) and not places.test(file.path)
    ]
    return nearest(without_unreached(repository, files))[:MAX_SOURCES]


def _local(repository: Repository, name: str) -> bool:
    """Tell whether a header lies in the tree: its last parts are those of a file there."""
    last = name.rpartition("/")[2].lower()
    candidates = repository.by_name.get(last)
    if not candidates:
        return name.startswith(".")
    if "/" not in name or name.startswith("."):
        return True
    return any(candidate.path.endswith("/" + name) or candidate.path == name for candidate in candidates)
