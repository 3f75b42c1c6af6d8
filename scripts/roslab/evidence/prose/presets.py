"""What ``cmake --preset NAME`` of a page means: the variables of CMakePresets.json.

https://cmake.org/cmake/help/latest/manual/cmake-presets.7.html#configure-preset, 2026-11-26.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

from roslab.evidence.facts import Mention
from roslab.evidence.prose.configured import PRESET
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

FILE = "CMakePresets.json"
_TESTS = pattern(r"(?:^|_)TEST(?:S|ING)?(?:_|$)")
_WORD = pattern(r"[\w.+-]+")


def with_variables(mention: Mention, repository: Repository) -> Mention:
    """Return what a page tells CMake with the variables of its preset written out; those that compile tests are not."""
    said = mention.text.split()
    names = [word.removeprefix(PRESET) for word in said if word.startswith(PRESET)]
    if not names:
        return mention
    others = [word for word in said if not word.startswith(PRESET)]
    set_ = {word.partition("=")[0].partition(":")[0] for word in others}
    meant = _variables(repository, mention, names[0])
    options = (f"-D{name}={value}" for name, value in meant.items() if f"-D{name}" not in set_)
    return replace(mention, text=" ".join((*others, *options)))


def _variables(repository: Repository, mention: Mention, name: str) -> dict[str, str]:
    folder = mention.file.rpartition("/")[0]
    file = next((file for file in repository.named(FILE) if file.folder == folder), None)
    try:
        presets = json.loads(repository.read(file))["configurePresets"] if file else []
        known = {preset["name"]: preset for preset in presets}
        return dict(_of(known, name, frozenset()))
    except (ValueError, TypeError, KeyError, AttributeError):
        return {}


def _of(known: Mapping[str, Mapping[str, object]], name: str, seen: frozenset[str]) -> Iterator[tuple[str, str]]:
    """Yield the variables of a preset after those that it inherits: the first of several parents decides."""
    preset = known.get(name)
    if preset is None or name in seen:
        return
    parents = preset.get("inherits", [])
    for parent in reversed([parents] if isinstance(parents, str) else list(parents)):  # type: ignore[call-overload]
        yield from _of(known, parent, seen | {name})
    for variable, said in dict(preset.get("cacheVariables") or {}).items():  # type: ignore[call-overload]
        value = said.get("value") if isinstance(said, dict) else said
        text = ("ON" if value else "OFF") if isinstance(value, bool) else str(value)
        if value is not None and _WORD.fullmatch(text) and not _TESTS.search(variable):
            yield variable, text
