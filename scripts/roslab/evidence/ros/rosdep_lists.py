"""The repository's own lists for rosdep: ``KEY: {ubuntu: [PACKAGE]}``, which its authors add to rosdep's sources.

https://docs.ros.org/en/independent/api/rosdep/html/rosdep_yaml_format.html
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.own_key import OwnKey
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
_NAMED = pattern(r"(?:^|/)\.?rosdeps?/(?:[^/]+/)*[^/]+$|rosdep[^/]*$", re.IGNORECASE)
"""In a folder for such lists, or named so itself."""
_ANY = "*"


def read(repository: Repository) -> tuple[OwnKey, ...]:
    """Return the keys with packages of Ubuntu, sorted by file; of two with one name, rosdep takes the first."""
    files = sorted(repository.suffixed(".yaml", ".yml"), key=lambda file: file.path)
    lists = [f for f in files if _NAMED.search(f.path) and f.size <= MAX_SIZE and not places.vendored(f.path)]
    found: dict[str, OwnKey] = {}
    for file in lists:
        for key in _keys(repository, file):
            found.setdefault(key.name, key)
    return tuple(found.values())


def _keys(repository: Repository, file: File) -> Iterator[OwnKey]:
    from roslab.evidence.lex.yaml import load  # noqa: PLC0415 - few trees have one

    text = repository.read(file, limit=MAX_SIZE)
    data = load(text)
    for name, systems in data.items() if isinstance(data, dict) else ():
        if isinstance(name, str) and isinstance(systems, dict) and (apt := tuple(_releases(systems.get("ubuntu")))):
            start = re.search(rf"^[\"']?{re.escape(name)}[\"']?[ \t]*:", text, re.MULTILINE)
            line = text.count("\n", 0, start.start()) + 1 if start else 1
            yield OwnKey(name=name, apt=apt, file=file.path, line=line)


def _releases(said: object) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield the packages of each release; of another installer than apt, such as pip, none."""
    if isinstance(said, dict) and not {"apt", "pip", "source", "gem", "snap"} & said.keys():
        for release, inner in said.items():
            if packages := _packages(inner):
                yield str(release), packages
    elif packages := _packages(said):
        yield _ANY, packages


def _packages(said: object) -> tuple[str, ...]:
    if isinstance(said, dict):
        apt = said.get("apt")
        said = apt.get("packages") if isinstance(apt, dict) else None
    line = isinstance(said, str) and "\n" not in said.strip()  # of more lines, the oldest lists held a script
    words = said.split() if isinstance(said, str) and line else said if isinstance(said, list) else []
    return tuple(word for word in words if isinstance(word, str))
