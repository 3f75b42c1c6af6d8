"""Libraries for x86-64 that CMake downloads, or that lie in the tree and are linked or opened, on every processor."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator, Sequence

from roslab.evidence import places
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native import elf
from roslab.evidence.native.x86 import always, cmake_files
from roslab.evidence.native.x86_searched import FINDING, searched
from roslab.evidence.x86_only import X86Only
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_WORDS = ("x86_64", "x86-64", "amd64", "linux-x64", "linux_x64")
_X86 = pattern(r"(?:^|[^a-z0-9])(?:x86[_-]64|amd64|linux[_-]x64)(?![a-z0-9])(?!-linux-gnu)")
"""A word of a path or an address; ``x86_64-linux-gnu`` is a folder of Debian's, whose libraries apt brings."""
_CHOOSES = pattern(r"SYSTEM_PROCESSOR|LIBRARY_ARCHITECTURE|\buname\b|aarch64|arm64|\barmv?\d|dpkg")
"""The file chooses by the processor."""
_ARCHIVE = pattern(r"https?://\S+\.(?:tar\.\w+|tgz|tbz2|txz|zip|deb|run|so(?:\.\d+)*|a)")
_FETCHING = frozenset({"file", "externalproject_add", "fetchcontent_declare"})
_LINKING = frozenset(
    (
        *("target_link_libraries", "link_libraries", "target_link_directories", "link_directories"),
        *("set_target_properties", "set_property"),
    )
)
_COPIED = pattern(r"lib([\w+-]+)\.so$")
"""A library in the build folder, by the name that the linker looks for."""
_CALLS = _FETCHING | _LINKING | FINDING | {"configure_file"}
_NAME = pattern(r"\.(?:so(?:\.\d+)*|a)$")
_SEARCHES = pattern(r"(?i)\b(?:find_library|link_directories)\b")
_LIBRARY = pattern(r"\.(?:so(?:\.\d+)*|a)(?=[\s)\"';])")
_ARCHIVE_OF_OBJECTS = b"!<arch>\n"
CODE = (".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp")
_OPENS = pattern(r"\bdlm?open\s*\(")
_NAMED = pattern(r"\"(?:[^\"\n]*/)?([\w.+-]+\.so)\"")
CHOOSES_IN_CODE = pattern(r"__aarch64__|__arm__|__x86_64__|\buname\b")
_OPENS_IN_PYTHON = pattern(r"\b(?:CDLL|PyDLL|LoadLibrary)\s*\(")
"""https://docs.python.org/3/library/ctypes.html#loading-shared-libraries, read 2026-11-26."""
_NAMED_IN_PYTHON = pattern(r"[\"'](?:[^\"'\n]*/)?([\w.+-]+\.so)[\"']")
_CHOOSES_IN_PYTHON = pattern(r"\bmachine\(|\buname\b|aarch64|arm64|x86_64")
MAX_LIBRARIES = 50
MAX_CODE = 3_000
MAX_HEAD = 1024 * 1024
"""What is read of a library: an archive begins with a table of names, before its first object."""
_ROOT = pattern(r"^\$\{(?:(?:PROJECT|CMAKE|CMAKE_CURRENT|\w+)_SOURCE_DIR|CMAKE_CURRENT_LIST_DIR)\}/")


def read(repository: Repository, modules: Iterable[tuple[str, str]]) -> Iterator[X86Only]:
    """Yield each such download or path, once for a file of CMake that does not choose by the processor.

    Then the first that code opens, and the first that ``modules`` of Python do: each a path with its text.
    """
    has = any(_NAME.search(file.name) for file in repository.files)
    for file in cmake_files(repository):
        text = repository.read(file)
        said = any(word in text for word in _WORDS) or _LIBRARY.search(text)
        if not (said or (has and _SEARCHES.search(text))) or _copied(file, repository) or _CHOOSES.search(text):
            continue
        found = tuple(call for call in calls(text, _CALLS) if always(call, repository))
        names = {word for call in found if call.name.endswith("link_libraries") for word in call.words}
        for call in found:
            if call.name == "configure_file" and not _copied_for(names, call):
                continue
            what = _fetched(call) if call.name in _FETCHING else _linked(call, file, repository)
            if what is None and has and call.name in FINDING:
                what = searched(call, file, names, text, repository, is_x86=is_x86)
            if what:
                yield X86Only(what, "binary", file.path, call.line)
                break
    libraries = [file for file in repository.suffixed(".so")[:MAX_LIBRARIES] if not places.vendored(file.path)]
    x86 = {file.path for file in libraries if is_x86(file.path, repository)}
    only = {file.name for file in libraries if file.path in x86} - {f.name for f in libraries if f.path not in x86}
    if only:
        yield from _opened(repository, libraries, only)
        yield from _opened_by_python(repository, modules, libraries, only)


def _opened_by_python(
    repository: Repository, modules: Iterable[tuple[str, str]], libraries: Sequence[File], only: set[str]
) -> Iterator[X86Only]:
    """Yield the first one that a module opens by its name, and that no build file of the tree names: it may make it."""
    for path, text in modules:
        if (
            places.aside(path)
            or "ctypes" not in text
            or not _OPENS_IN_PYTHON.search(text)
            or _CHOOSES_IN_PYTHON.search(text)
        ):
            continue
        for named in _NAMED_IN_PYTHON.finditer(text):
            if named[1] in only and not _made(named[1], repository):
                found = next(file.path for file in libraries if file.name == named[1])
                yield X86Only(found, "opened by Python", path, text.count("\n", 0, named.start()) + 1)
                return


def _made(name: str, repository: Repository) -> bool:
    """Tell whether a build file of the tree names a library, with what stands before and after its name or without."""
    bare = name.removesuffix(".so").removeprefix("lib")
    files = (*repository.named("Makefile"), *repository.named("CMakeLists.txt"), *repository.named("setup.py"))
    return any(bare in repository.read(file) for file in (*files, *repository.suffixed(".sh", ".mk")))


def _opened(repository: Repository, libraries: Sequence[File], only: set[str]) -> Iterator[X86Only]:
    """Yield the library of the tree that code of C or C++ opens by its name, if all of that name are for x86-64."""
    code = [file for file in repository.suffixed(*CODE)[:MAX_CODE] if not places.vendored(file.path)]
    texts = {file.path: repository.read(file) for file in code}
    if not any("open" in text and _OPENS.search(text) for text in texts.values()):
        return
    for path, text in texts.items():
        if '.so"' not in text or CHOOSES_IN_CODE.search(text):
            continue
        for named in _NAMED.finditer(text):
            if named[1] in only:
                found = next(file.path for file in libraries if file.name == named[1])
                yield X86Only(found, "opened", path, text.count("\n", 0, named.start()) + 1)
                return


def _copied_for(names: set[str], call: Call) -> bool:
    """Tell whether a file is copied to where programs link it by its name: ``COPYONLY``."""
    copied = _COPIED.search(call.words[1]) if "COPYONLY" in call.words[2:] else None
    return copied is not None and copied[1] in names


def _fetched(call: Call) -> str | None:
    """Return the address that a call downloads."""
    if call.name == "file" and call.words[:1] != ("DOWNLOAD",):
        return None
    return next((word for word in call.words if _ARCHIVE.fullmatch(word) and _X86.search(word)), None)


def _linked(call: Call, file: File, repository: Repository) -> str | None:
    """Return the path of what a call links and the tree has."""
    for word in call.words:
        named, library = _X86.search(word), _LIBRARY.search(f"{word} ")
        path = posixpath.normpath(posixpath.join(file.folder, _ROOT.sub("", word))) if named or library else ""
        if named and (repository.has(path) or path in repository.folders):
            return path
        if library and repository.has(path) and is_x86(path, repository):
            return path
    return None


def is_x86(path: str, repository: Repository) -> bool:
    """Tell whether a library, or the first object of an archive, is compiled for x86-64."""
    data = repository.read_bytes(path, limit=MAX_HEAD)
    start = data.find(elf.MAGIC) if data.startswith(_ARCHIVE_OF_OBJECTS) else 0
    return start >= 0 and elf.machine(data[start : start + elf.HEADER]) == elf.X86_64


def _copied(file: File, repository: Repository) -> bool:
    """Tell whether a file lies in copied code; a package of ROS in a folder of such code is built as the others."""
    folder = file.folder
    while folder and not repository.has(f"{folder}/package.xml"):
        folder = folder.rpartition("/")[0]
    return places.vendored(file.path.removeprefix(f"{folder}/"))
