"""Code of CUDA that is compiled for one generation of GPUs and for no later one.

https://docs.nvidia.com/cuda/cuda-compiler-driver-nvcc/#gpu-feature-list, read 2026-11-27: what is compiled as ``sm_50``
runs on GPUs 5.x alone; a newer one needs PTX (``code=compute_50``), which its driver compiles.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.lex.lines import end_of_line, lines_with
from roslab.evidence.native import gpus
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_CODE = pattern(r"code=[\[\"'\\]*((?:(?:sm|compute|lto)_\w+,?)+|[^\s\"';]*)")
_REAL = pattern(r"sm_(\d+)(\d)")
"""Without the suffixes a and f: PTX of these runs on no later generation either."""
_WITH_PTX = pattern(r"(?<!code)(?:-arch|--gpu-architecture)[= ]+(?:sm|compute)_\d")
"""Without ``-code``, it stands for the machine code and PTX."""


def read(repository: Repository) -> Iterator[tuple[str, str, int]]:
    """Yield what the author should know of the first build file whose code all newer GPUs refuse."""
    for file in gpus.files(repository):
        text = repository.read(file)
        if "code=" not in text or "sm_" not in text:
            continue
        passed = list(_lines(file, text))
        said = [(part, line) for words, line in passed for part in _CODE.findall(words)]
        names = [name for parts, _ in said for name in parts.strip("]'\"\\").split(",") if name]
        real = [_REAL.fullmatch(name) for name in names]
        if not names or not all(real) or any(_WITH_PTX.search(words) for words, _ in passed):
            continue  # a variable, PTX for the rest, or code that no PTX helps
        generations = {match[1] for match in real if match}
        if len(generations) == 1:
            yield _told(generations.pop(), max(names).replace("sm", "compute")), file.path, said[0][1]
            return


def _told(generation: str, virtual: str) -> str:
    return (
        f"CUDA's code is compiled for GPUs of compute capability {generation}.x alone, without PTX: on a newer one "
        f"nothing of it runs; add -gencode arch={virtual},code={virtual}"
    )


def _lines(file: File, text: str) -> Iterator[tuple[str, int]]:
    """Yield what may be options of the compiler, each with its line."""
    if file.name.endswith((".txt", ".cmake")):
        for call in gpus.passing(text):
            yield " ".join(call.written), call.line
        return
    for start in lines_with(text, "code="):
        yield text[start : end_of_line(text, start)].partition("#")[0], text.count("\n", 0, start) + 1
