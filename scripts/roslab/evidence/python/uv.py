"""What uv reads in a pyproject.toml and pip does not: where packages come from, and groups of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_OF_WORK = pattern(r"(?:^|[-_])(?:dev|develop|development|tests?|testing|lint|docs?|typing|format|ci|build)(?:$|[-_])")
"""A group for those who work on the project."""


def as_installed(asked: Requirement, sources: Mapping[str, Any]) -> Requirement:
    """Return a requirement as uv would install it: pip knows neither its sources nor the members of its workspace.

    https://docs.astral.sh/uv/concepts/projects/dependencies/#dependency-sources.
    """
    said = next((value for key, value in sources.items() if canonicalize_name(key) == asked.key), None)
    said = said[0] if isinstance(said, list) and said else said
    if not isinstance(said, dict):
        return asked
    if said.get("workspace") or "path" in said:
        return replace(asked, role="member")
    if isinstance(said.get("git"), str):
        ref = said.get("rev") or said.get("tag") or said.get("branch")
        folder = f"#subdirectory={said['subdirectory']}" if said.get("subdirectory") else ""
        return asked.fetched_from(f"git+{said['git']}" + (f"@{ref}" if ref else "") + folder)
    return asked.fetched_from(said["url"]) if isinstance(said.get("url"), str) else asked


def default_groups(data: Mapping[str, Any]) -> list[str]:
    """Return the lines of the groups that ``uv sync`` installs because the project says so.

    ``data``: the pyproject.toml. A group may include others (PEP 735). Without ``default-groups`` uv installs ``dev``
    alone, which like others for work on the project is no part of the image.
    https://docs.astral.sh/uv/concepts/projects/dependencies/#default-groups, read 2026-11-26.
    """
    tool = data.get("tool")
    uv = tool.get("uv") if isinstance(tool, dict) else None
    wanted = uv.get("default-groups") if isinstance(uv, dict) else None
    if not wanted:
        return []
    known = groups_of(data)
    names = list(known) if wanted == "all" else wanted if isinstance(wanted, list) else []
    names = [name for each in names if not of_work(name := canonicalize_name(str(each)))]
    return list(dict.fromkeys(line for name in names for line in known.get(name, ())))


def groups_of(data: Mapping[str, Any]) -> dict[str, list[str]]:
    """Return the lines of each dependency group of a pyproject.toml, with those of the groups that it includes."""
    groups = data.get("dependency-groups")
    named = {canonicalize_name(str(name)): lines for name, lines in groups.items()} if isinstance(groups, dict) else {}
    return {name: list(_lines(named, name, frozenset())) for name in named}


def of_work(name: str) -> bool:
    """Tell whether a group is for those who work on the project, by its name in lower case."""
    return bool(_OF_WORK.search(name))


def _lines(groups: Mapping[str, Any], name: str, seen: frozenset[str]) -> Iterator[str]:
    """Yield the lines of a group and of those that it includes; what includes itself adds nothing."""
    lines = groups.get(name) if name not in seen else None
    for line in lines if isinstance(lines, list) else ():
        if isinstance(line, str):
            yield line
        elif isinstance(line, dict) and "include-group" in line:
            yield from _lines(groups, canonicalize_name(str(line["include-group"])), seen | {name})
