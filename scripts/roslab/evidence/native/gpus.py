"""The GPUs that build files compile for, as limits of the CUDA whose compiler knows them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.lex.cmake import EVERY, Call, calls
from roslab.evidence.lex.lines import end_of_line, lines_with
from roslab.evidence.lex.truth import cmake_holds
from roslab.knowledge.cuda_gpus import NAME, cuda_of_gpu
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_FILES = 100
MAX_SIZE = 64 * 1024
_NEAR = 200
"""Most characters between a condition of a Makefile or of Python and what it guards."""
_GPU = pattern(r"(?:compute|sm)_(\d{2,3})a?(?!\w)")
_NUMBER = pattern(r"(?<![\w.])(\d{2,3})(?:-real|-virtual|a)?(?![\w.])")
_OPTIONS = ("compute_", "sm_")
_LISTS = frozenset({"CMAKE_CUDA_ARCHITECTURES", "CUDA_ARCHITECTURES"})
_CALLS = frozenset({"set", "list", "set_property", "set_target_properties", "target_compile_options", "string"})
_BRINGS = frozenset({"enable_language", "find_package", "project"})
_TOOLKITS = frozenset({"CUDA", "CUDAToolkit"})


def read(repository: Repository) -> tuple[CodeLimit, ...]:
    """Return, for each GPU that is compiled for on every machine, the CUDA versions that know it, at its first place.

    Nothing of copied code, examples and tests, and nothing below a condition that may not hold: around the flags,
    around every use of their variable, or around all that brings CUDA.
    """
    found: dict[int, CodeLimit] = {}
    for file in files(repository):
        for architecture, line in _in(file, repository.read(file)):
            first, after = cuda_of_gpu(architecture)
            if first and architecture not in found:
                found[architecture] = CodeLimit(
                    library=NAME, at_least=first, below=after, what=f"sm_{architecture}", file=file.path, line=line
                )
    return tuple(found.values())


def files(repository: Repository) -> list[File]:
    """Return the build files that are searched, those nearest to the root first."""
    found = (*repository.named("CMakeLists.txt", "Makefile", "setup.py"), *repository.suffixed(".cmake"))
    aside = (places.vendored, places.example, places.test, places.documentation)
    kept = [file for file in found if file.size <= MAX_SIZE and not any(each(file.path) for each in aside)]
    return nearest(kept)[:MAX_FILES]


def _in(file: File, text: str) -> Iterator[tuple[int, int]]:
    """Yield each architecture with its line."""
    if file.name.endswith((".txt", ".cmake")):
        yield from _in_cmake(text) if any(word in text for word in (*_OPTIONS, "CUDA_ARCHITECTURES")) else ()
        return
    for start in lines_with(text, *_OPTIONS):
        line = text[start : end_of_line(text, start)].partition("#")[0]
        if not line.lstrip().startswith(("if", "elif")) and "if " not in text[max(0, start - _NEAR) : start]:
            yield from ((int(match[1]), text.count("\n", 0, start) + 1) for match in _GPU.finditer(line))


def _in_cmake(text: str) -> Iterator[tuple[int, int]]:
    if _left_out(call for call in calls(text, _BRINGS) if _TOOLKITS & set(call.written)):
        return
    for call in passing(text):
        for index, word in enumerate(call.written):
            yield from ((int(match[1]), call.line) for match in _GPU.finditer(word))
            if word in _LISTS:
                yield from (
                    (int(m[1]), call.line) for each in call.written[index + 1 :] for m in _NUMBER.finditer(each)
                )


def passing(text: str) -> Iterator[Call]:
    """Yield the calls of a file of CMake that may give options to CUDA's compiler, on every machine."""
    for call in calls(text, _CALLS):
        if not (call.in_function or not _taken(call) or _unused(call, text)):
            yield call


def _taken(call: Call) -> bool:
    return all(cmake_holds(condition, lambda _: False) for condition in call.conditions)


def _left_out(found: Iterable[Call]) -> bool:
    """Tell whether there are calls, and all of them wait for a condition that may not hold."""
    taken = [_taken(call) for call in found]
    return bool(taken) and not any(taken)


def _unused(call: Call, text: str) -> bool:
    """Tell whether a variable of the file's own is set that only an option which may be off uses."""
    if call.name != "set" or not call.written or not any(_GPU.search(word) for word in call.written[1:]):
        return False
    use = f"${{{call.written[0]}}}"
    return text.count(use) > 0 and _left_out(
        each for each in calls(text, EVERY) if each.line != call.line and any(use in word for word in each.written)
    )
