"""The list of gitman: ``sources``, and the commits of them that were locked. https://gitman.readthedocs.io/."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.values.pattern import pattern

_INSTALLS = pattern(r"(?:^|&& ?|; ?)gitman (?:install|update)\b")


def entries(data: dict[object, object]) -> Iterator[tuple[str, object, object]]:
    """Yield what is listed, at the commits that were locked; ``name`` is the folder, if it has one."""
    listed = [entry for entry in _entries(data, "sources") if entry.get("type", "git") == "git"]
    locked = {_folder(entry): entry.get("rev") for entry in _entries(data, "sources_locked")}
    for entry in listed:
        yield _folder(entry), entry.get("repo"), locked.get(_folder(entry)) or entry.get("rev")


def lists(data: object) -> frozenset[str]:
    """Return the folders of those in which gitman is called once they are cloned: what they list belongs to it, too.

    https://gitman.readthedocs.io/en/latest/use-cases/nested-dependencies/ and the key ``scripts``, read 2026-11-28.
    """
    found = _entries(data, "sources") if isinstance(data, dict) else []
    return frozenset(_folder(entry) for entry in found if any(map(_INSTALLS.search, _scripts(entry))))


def _scripts(entry: dict[str, object]) -> list[str]:
    said = entry.get("scripts")
    return [line for line in said if isinstance(line, str)] if isinstance(said, list) else []


def _entries(data: dict[object, object], key: str) -> list[dict[str, object]]:
    listed = data.get(key)
    return [entry for entry in listed if isinstance(entry, dict)] if isinstance(listed, list) else []


def _folder(entry: dict[str, object]) -> str:
    return str(entry.get("name") or str(entry.get("repo")).rstrip("/").rpartition("/")[2].removesuffix(".git"))
