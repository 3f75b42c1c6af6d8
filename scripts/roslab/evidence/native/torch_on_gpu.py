"""Code that needs the libtorch for CUDA: an address of its archive, and what moves tensors to a GPU in any case."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import end_of_line, lines_with
from roslab.evidence.native.limits import conditional
from roslab.evidence.native.unlisted import Unlisted
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

TOPIC: Literal["torch_on_gpu"] = "torch_on_gpu"
_ARCHIVE = pattern(r"libtorch/cu(\d{2,3})/[^\s\"')]{0,200}?(?:-(\d+\.\d+\.\d+))?(?:%2B|\+|\.zip)")
_SCRIPTS = (".sh", ".bash", ".md", ".rst", ".cmake", ".yml", ".yaml")
_NAMES = ("Dockerfile", "CMakeLists.txt")
_SOURCES = (".cpp", ".cc", ".cxx", ".h", ".hpp")
_MOVES = pattern(r"(?:torch|at|c10)::(?:Device\s*\(\s*)?(?:torch::|at::)?kCUDA\b|\.cuda\(\)|DeviceType::CUDA\b")
_ASKS = ("is_available", "hasCUDA", "device_count", "getNumGPUs")
"""Calls by which code finds out whether there is a GPU."""
_BRANCH = pattern(r"\b(?:if|else|case|catch)\b|\?|#\s*(?:if|else)|\bkCPU\b")
_COMMENT = pattern(r"//[^\n]*")
_ABOVE = 3
"""Lines above a place in which a condition may stand."""
MAX_FILES = 400
MAX_SIZE = 256 * 1024


def read(repository: Repository, projects: Iterable[CMakeProject]) -> Iterator[Mention]:
    """Yield the first address of an archive, and the first such place in compiled code, where CMake asks for Torch.

    No address where there is one for the CPU too: the author leaves the choice.

    ``value``: the CUDA of the archive, with the release behind a blank where the address has it; none for code.
    """
    asked = (d for each in projects if not places.aside(each.file) for d in each.dependencies)
    if any(d.namespace == "cmake" and d.name == "Torch" and d.strength != "optional" for d in asked):
        yield from _archives(repository)
        yield from _code(repository)


def _archives(repository: Repository) -> Iterator[Mention]:
    files = nearest((*repository.suffixed(*_SCRIPTS), *repository.named(*_NAMES)))[:MAX_FILES]
    files = [file for file in files if file.size <= MAX_SIZE and not places.vendored(file.path)]
    if any("libtorch/cpu/" in repository.read(file) for file in files):
        return
    for file in sorted(files, key=lambda each: each.path.endswith(places.OF_CI)):
        text = repository.read(file)
        for match in _ARCHIVE.finditer(text) if "libtorch/cu" in text else ():
            start = text.rfind("\n", 0, match.start()) + 1
            if text[start : match.start()].lstrip().startswith("#"):
                continue
            cuda = f"{match[1][:-1]}.{match[1][-1]}"
            value = f"{cuda} {match[2]}" if match[2] else cuda
            yield _mention(value, file.path, text, match.start(), f"libtorch/cu{match[1]}")
            return


def _code(repository: Repository) -> Iterator[Mention]:
    unlisted = Unlisted(repository)
    for file in nearest(repository.suffixed(*_SOURCES))[:MAX_FILES]:
        if file.size > MAX_SIZE or places.aside(file.path):
            continue
        text = repository.read(file)
        if "torch" not in text or any(word in text for word in _ASKS) or unlisted.has(file.path):
            continue
        for start in lines_with(text, "kCUDA", ".cuda()", "::CUDA"):
            line = _COMMENT.sub("", text[start : end_of_line(text, start)])
            match = _MOVES.search(line)
            if match and not (_may_be_left_out(text, start, line) or conditional(text, start)):
                yield _mention("", file.path, text, start, match[0])
                return


def _may_be_left_out(text: str, start: int, line: str) -> bool:
    """Tell whether a condition stands on a line or close above it, in an open comment too."""
    before = _COMMENT.sub("", "\n".join(text[max(0, start - 2_000) : start].split("\n")[-_ABOVE - 1 :])).split("\n")
    commented = text.rfind("/*", 0, start) > text.rfind("*/", 0, start)
    return commented or any(map(_BRANCH.search, (*before, line)))


def _mention(value: str, path: str, text: str, position: int, said: str) -> Mention:
    line = text.count("\n", 0, position) + 1
    return Mention(topic=TOPIC, value=value, source="code", file=path, line=line, text=said)
