"""Code that has ONNX Runtime compute on a GPU: ``options.AppendExecutionProvider_CUDA(cuda)``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import matches_at
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

TOPIC: Literal["onnx_on_gpu"] = "onnx_on_gpu"
_CALLED = pattern(r"AppendExecutionProvider_(?:CUDA|Tensor[Rr][Tt])(?:_V2)?(?=[ \t]*\()")
_SIGN = "AppendExecutionProvider_"
_SOURCES = (".cpp", ".cc", ".cxx", ".h", ".hpp")
_BUILD_FILES = ("CMakeLists.txt", "package.xml")
_LIBRARY = "onnxruntime"
MAX_FILES = 1_000
"""Most files that are searched, those nearest to the root first."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such call, where a build file names the library; none in a comment of one line."""
    if not any(_LIBRARY in repository.read(each).lower() for each in repository.named(*_BUILD_FILES)):
        return
    for file in nearest(repository.suffixed(*_SOURCES))[:MAX_FILES]:
        text = "" if places.aside(file.path) else repository.read(file)
        for match in matches_at(_CALLED, text, _SIGN) if _SIGN in text else ():
            before = text[text.rfind("\n", 0, match.start()) + 1 : match.start()]
            if "//" not in before:
                line = text.count("\n", 0, match.start()) + 1
                yield Mention(topic=TOPIC, value="", source="code", file=file.path, line=line, text=match[0])
                return
