"""Toolkits of CUDA whose folder a file of CMake names: ``/usr/local/cuda-10.2``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import end_of_line, matching_lines
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

FOLDER = "/usr/local/cuda-"
_PATH = pattern(r"[^#\n]{0,400}?/usr/local/cuda-(\d{1,2}\.\d)\b(?![\w.-])")
"""https://docs.nvidia.com/cuda/archive/10.2/cuda-installation-guide-linux/index.html#environment-setup, 2026-11-27"""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each version once, at the first place that names its folder; none of vendored code, examples or tests."""
    told: set[str] = set()
    for file in (*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake")):
        text = "" if places.aside(file.path) else repository.read(file)
        for match in matching_lines(_PATH, text, FOLDER) if FOLDER in text else ():
            if match[1] not in told:
                told.add(match[1])
                line = text.count("\n", 0, match.start()) + 1
                said = text[match.start() : end_of_line(text, match.start())].strip()[:120]
                yield Mention(topic="cuda_path", value=match[1], source="code", file=file.path, line=line, text=said)
