"""Compiler options and headers of x86 alone, where a build for ARM would use them as well."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.lex.lines import end_of_line, lines_with, matches_at
from roslab.evidence.lex.truth import cmake_holds
from roslab.evidence.x86_only import X86Only
from roslab.knowledge.x86_only import x86_only
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

MAX_FILES = 300
"""Most files of a kind that are searched, those nearest to the root first."""
MAX_SIZE = 64 * 1024
MAX_COPIED = 1_000
"""Most files of copied code that are searched, where options are passed."""
_PASSING = frozenset(
    (
        *("add_compile_options", "add_definitions", "add_compile_definitions", "target_compile_options"),
        *("target_compile_definitions", "set_target_properties", "set_source_files_properties", "set_property"),
        *("rosbuild_add_compile_flags", "add_compile_flags", "cuda_add_library", "cuda_add_executable"),
    )
)
_SETTING = frozenset({"set", "list", "string"})
_FLAGS = pattern(r"CMAKE_(?:C|CXX|CUDA)_FLAGS\w*|CUDA_NVCC_FLAGS\w*|ROS_(?:COMPILE|LINK)_FLAGS")
_NAME = pattern(r"[A-Za-z]\w+")
_CONDITION = pattern(
    r"\s*(?:#|(?:else|end)?if\b|option\s*\(\s*\w+\s+\"[^\"\n]{0,400}\"\s*(?:(?:OFF|FALSE|NO|0)\s*)?\))", re.IGNORECASE
)
"""A condition, or the declaration of an option that is off."""
_VARIABLE = pattern(r"\$\{(\w+)\}")
_INCLUDE = pattern(r"include[ \t]*[<\"](\w+\.h)[>\"]")
_CHOOSES = pattern(r"uname\b|platform\.machine|aarch64|arm64|\barmv?\d?\b|x86_64|\bCPU_?ARCH|\bARCH\b|cpuinfo")
_ENDS = ("intrin.h", "cpuid.h")
"""How every header of x86 alone ends."""
_HEADERS = (".h", ".hpp", ".hh", ".cuh")
_SOURCES = (*_HEADERS, ".c", ".cc", ".cpp", ".cxx", ".cu")


@dataclass
class Intrinsics:
    """The includes of headers of x86 alone that were found so far, each with the text around it."""

    found: list[tuple[str, str, str, int]] = field(default_factory=list)
    """Header, file, text, position."""

    def source(self, path: str, text: str) -> None:
        """Read a file in C, C++ or CUDA."""
        if not any(end in text for end in _ENDS):
            return
        for match in _INCLUDE.finditer(text):
            before = text[text.rfind("\n", 0, match.start()) + 1 : match.start()].strip()
            if before == "#":
                self.header(match[1], path, text, match.start())

    def header(self, name: str, path: str, text: str, position: int) -> None:
        """Read an include at a position of such a file."""
        if tells(name) and x86_only("header").fullmatch(name) and not places.example(path):
            self.found.append((name, path, text, position))


def tells(header: str) -> bool:
    """Tell whether a header may be one of x86 alone: each file that includes it matters."""
    return header.endswith(_ENDS)


def read(repository: Repository, intrinsics: Intrinsics, included: Collection[str]) -> tuple[X86Only, ...]:
    """Return what only x86 has and what no condition keeps from a build for ARM; nothing of examples and tests.

    ``intrinsics``: of the sources that were read; ``included``: the last parts of the headers that they include.
    """
    options = [*_of_cmake(repository), *_of_texts(repository)]
    if options:  # what is copied in is compiled with the same options
        _read_copied(repository, intrinsics)
    found: dict[tuple[str, str], X86Only] = {}
    for each in (*options, *_used(repository, intrinsics, included)):
        found.setdefault((each.what, each.file), each)
    return tuple(found.values())


def _used(repository: Repository, intrinsics: Intrinsics, included: Collection[str]) -> Iterator[X86Only]:
    for header, path, text, position in intrinsics.found:
        if repository.named(header):
            continue  # a file of the tree is called so
        name = path.rpartition("/")[2]
        if name.endswith(_HEADERS) and name not in included and not places.vendored(path):
            continue  # nothing compiles it
        from roslab.evidence.lex.preprocessor import reached  # noqa: PLC0415 - few trees have them

        if reached(text, position, lambda macro: _defined(repository, macro)):
            yield X86Only(header, "header", path, text.count("\n", 0, position) + 1)


def _read_copied(repository: Repository, intrinsics: Intrinsics) -> None:
    files = (file for file in repository.suffixed(*_SOURCES) if file.size <= MAX_SIZE and places.vendored(file.path))
    for file in _nearest(files)[:MAX_COPIED]:
        intrinsics.source(file.path, repository.read(file))


def _nearest(files: Iterable[File]) -> list[File]:
    kept = (f for f in files if not (places.test(f.path) or places.example(f.path) or places.documentation(f.path)))
    return nearest(kept)


def cmake_files(repository: Repository) -> tuple[File, ...]:
    """Return the files of CMake that are searched."""
    return repository.once(_cmake_files)


def _cmake_files(repository: Repository) -> tuple[File, ...]:
    files = (*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake"))
    return tuple(_nearest(file for file in files if file.size <= MAX_SIZE)[:MAX_FILES])


def _of_cmake(repository: Repository) -> Iterator[X86Only]:
    """Yield the options that files of CMake pass to every compiler."""
    found: list[tuple[File, Call]] = []
    for file in cmake_files(repository):
        text = repository.read(file)
        if "-m" in text and any(True for _ in matches_at(x86_only("option"), text, "-m")):
            found += [(file, call) for call in calls(text, _PASSING | _SETTING) if always(call, repository)]
    used = {
        name
        for _, call in found
        if _passes(call, frozenset())
        for word in call.written
        for name in _VARIABLE.findall(word)
    }
    for file, call in found:
        if _passes(call, used):
            for word in call.written:
                for match in x86_only("option").finditer(word if "PROCESSOR" not in word else ""):
                    yield X86Only(match[0], "cmake", file.path, call.line)


def always(call: Call, repository: Repository) -> bool:
    """Tell whether a call takes effect on ARM, by all that is known."""

    def unset(name: str) -> bool:
        return _unset(name, repository)

    return not call.in_function and all(cmake_holds(condition, unset) for condition in call.conditions)


def _unset(name: str, repository: Repository) -> bool:
    """Tell whether conditions alone name a variable: nothing in the tree gives it a value, or turns it on."""
    if not _NAME.fullmatch(name) or name.startswith("CMAKE_"):
        return False
    lines = (line for file in cmake_files(repository) for line in _with(repository.read(file), name))
    return all(_CONDITION.match(line) for line in lines)


def _with(text: str, word: str) -> Iterator[str]:
    return (text[start : end_of_line(text, start)] for start in lines_with(text, word))


def _passes(call: Call, used: Collection[str]) -> bool:
    """Tell whether a call gives options to the compiler, itself or by a variable that is used for them."""
    if call.name in _PASSING:
        return True
    names = (
        call.written[1:2] if call.name == "list" else call.written[-1:] if call.name == "string" else call.written[:1]
    )
    if call.name == "string" and call.written[:1] == ("APPEND",):
        names = call.written[1:2]
    return any(_FLAGS.fullmatch(name) or name in used for name in names)


def _of_texts(repository: Repository) -> Iterator[X86Only]:
    """Yield the options in Makefiles and in setup.py, where the file does not choose by the processor."""
    makefiles = repository.named("Makefile", "makefile", "GNUmakefile")
    for file in _nearest(f for f in (*makefiles, *repository.named("setup.py")) if f.size <= MAX_SIZE)[:MAX_FILES]:
        text = repository.read(file)
        if "-m" not in text or places.vendored(file.path) or _CHOOSES.search(text):
            continue
        for match in matches_at(x86_only("option"), text, "-m"):
            line = text.rfind("\n", 0, match.start()) + 1
            if "#" not in text[line : match.start()]:
                number = text.count("\n", 0, match.start()) + 1
                yield X86Only(match[0], "setup.py" if file.name == "setup.py" else "make", file.path, number)


def _defined(repository: Repository, macro: str) -> bool:
    """Tell whether a file of CMake defines a macro on every processor: ``-DUSE_SSE``."""
    word = f"-D{macro}"
    for file in cmake_files(repository):
        text = repository.read(file)
        if macro not in text:
            continue
        for call in calls(text, _PASSING | _SETTING):
            said = {part.removesuffix("=1") for each in call.written for part in each.split()}
            defines = word in said or (call.name.endswith("definitions") and macro in said)
            if defines and _passes(call, frozenset()) and always(call, repository):
                return True
    return False
