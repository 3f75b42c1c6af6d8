"""Toolkits of CUDA whose folder a file of CMake names: ``/usr/local/cuda-10.2``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import EVERY, Call, calls
from roslab.evidence.lex.lines import end_of_line, matching_lines
from roslab.evidence.native.x86 import cmake_files
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

FOLDER = "/usr/local/cuda-"
UNSURE = "hints"
"""What a version stands in that only hints and branches for other processors name."""
_NAMED = rf"{FOLDER}(\d{{1,2}}\.\d)(?![\w.-])"
"""https://docs.nvidia.com/cuda/archive/10.2/cuda-installation-guide-linux/index.html#environment-setup, 2026-11-27"""
_VERSION = pattern(_NAMED)
_UNMARKED = pattern(rf"[^#\n]{{0,400}}?{_NAMED}")
_ELSEWHERE = pattern(r"aarch64|arm64|\barmv?\d|jetson|tegra|l4t|\bEXISTS\b", re.IGNORECASE)
_TURNED = pattern(r"NOT \(?")
_HINTS = pattern(r"(?:\w*_)?(?:HINTS?|PATHS|SEARCH_\w+|CANDIDATES)|/usr/local/cuda(?:/.*)?")
"""A word of a call that lists where something may be: also the folder of whichever toolkit is there."""
_SEARCHES = ("find_library", "find_path", "find_file", "find_program", "find_package")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each version once, at the first place that names its folder; none of vendored code, examples or tests.

    What nothing but hints and branches for other processors names says so (``inside``).
    """
    found: dict[str, Mention] = {}
    for file in cmake_files(repository):
        text = "" if places.vendored(file.path) else repository.read(file)
        if FOLDER not in text:
            continue
        plain = set() if file.name.startswith("Find") else _plainly(text)
        for match in matching_lines(_UNMARKED, text, FOLDER):
            line = text.count("\n", 0, match.start()) + 1
            said = text[match.start() : end_of_line(text, match.start())].strip()[:120]
            inside = "" if match[1] in plain else UNSURE
            mention = Mention(
                topic="cuda_path", value=match[1], source="code", file=file.path, line=line, text=said, inside=inside
            )
            first = found.setdefault(match[1], mention)
            if first.inside and not inside:
                found[match[1]] = mention
    yield from found.values()


def _plainly(text: str) -> set[str]:
    """Return the versions whose folders calls name that are no hints and for every processor."""
    return {
        version
        for call in calls(text, EVERY)
        if not _is_hint(call) and not any(map(_of_another, call.conditions))
        for word in call.written
        for version in _VERSION.findall(word)
    }


def _is_hint(call: Call) -> bool:
    return call.name in _SEARCHES or any(map(_HINTS.fullmatch, call.written))


def _of_another(condition: str) -> bool:
    """Tell whether a condition holds on other processors, or only where a folder is there."""
    turned = False
    while match := _TURNED.match(condition):
        turned, condition = not turned, condition[match.end() :]
    return bool(_ELSEWHERE.search(condition)) and not turned
