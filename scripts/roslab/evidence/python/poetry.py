"""Poetry's own table of dependencies, as requirement lines.

https://python-poetry.org/docs/dependency-specification/.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any

from roslab.values.name import canonicalize_name
from roslab.values.specifier import specifiers


def python(table: dict[str, Any]) -> str | None:
    """Return the Python that a project is for, in the notation of ``requires-python``."""
    said = table.get("python")
    return _as_written(_first(said)) or None if isinstance(said, str) else None


def lines(table: dict[str, Any], extra: frozenset[str] | None = None) -> Iterator[str]:
    """Yield each dependency, once per alternative, except those of extras and those in the tree.

    With ``extra`` those alone that an extra of these names asks for.
    """
    for name, said in table.items():
        if name == "python" or (extra is not None and name not in extra):
            continue
        for value in said if isinstance(said, list) else [said]:
            described = value if isinstance(value, dict) else {"version": value}
            if (extra is None and described.get("optional")) or (required := _required(name, described)) is None:
                continue
            condition = " and ".join(_conditions(described))
            yield f"{required} ; {condition}" if condition else required


def groups_of(table: dict[str, Any]) -> dict[str, list[str]]:
    """Return the lines of each dependency group; ``table`` is Poetry's own of a pyproject.toml.

    https://python-poetry.org/docs/managing-dependencies/#dependency-groups, read 2026-11-26.
    """
    return {name: list(lines(own)) for name, _, own in _groups(table)}


def default_groups(table: dict[str, Any]) -> list[str]:
    """Return the lines of the groups that ``poetry install`` installs: none that is optional or for work on it."""
    from roslab.evidence.python.uv import of_work  # noqa: PLC0415 - many trees have no pyproject.toml

    return [
        line for name, said, own in _groups(table) if not (said.get("optional") or of_work(name)) for line in lines(own)
    ]


def _groups(table: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any], dict[str, Any]]]:
    """Yield the name of each group, what is said of it and its dependencies."""
    groups = table.get("group")
    for name, said in groups.items() if isinstance(groups, dict) else ():
        own = said.get("dependencies") if isinstance(said, dict) else None
        if isinstance(own, dict):
            yield canonicalize_name(str(name)), said, own


def _required(name: str, said: dict[str, Any]) -> str | None:
    if isinstance(said.get("git"), str):
        ref = said.get("rev") or said.get("tag") or said.get("branch")
        return f"{name} @ git+{said['git']}" + (f"@{ref}" if ref else "")
    if isinstance(said.get("url"), str):
        return f"{name} @ {said['url']}"
    version = said.get("version", "*")
    if "path" in said or not isinstance(version, str):
        return None
    version = _first(version)
    listed = said.get("extras")
    extras = ",".join(each for each in listed if isinstance(each, str)) if isinstance(listed, list) else ""
    allowed = "" if version in {"*", ""} else _as_written(version)
    return name + (f"[{extras}]" if extras else "") + allowed


def _as_written(version: str) -> str:
    """Return specifiers in the order of their author: ``^1.2`` is ``>=1.2,<2``, a bare number is that release."""
    parts = [part.strip() for part in version.split(",")]
    return ",".join(f"=={part}" if part[:1].isdigit() else _spelled(part) for part in parts if part not in {"*", ""})


def _spelled(part: str) -> str:
    read = specifiers(part) if part[0] in "^~" else None
    return part.replace(" ", "") if read is None else ",".join(sorted(map(str, read), reverse=True))


def _conditions(said: dict[str, Any]) -> Iterator[str]:
    """Yield a dependency's markers: its own, the Pythons and the platform that it is for."""
    if isinstance(said.get("markers"), str):
        yield f"({said['markers']})"
    if isinstance(said.get("platform"), str):
        yield f'sys_platform == "{said["platform"]}"'
    allowed = specifiers(_first(said["python"])) if isinstance(said.get("python"), str) else None
    parts: list[Any] = sorted(allowed or (), key=str)
    for each in parts:
        series = each.version.removesuffix(".*").count(".") < 2
        yield f'{"python_version" if series else "python_full_version"} {each.operator} "{each.version}"'


def _first(version: str) -> str:
    """Return the first of several alternatives: pip has no notation for them."""
    return version.partition("||")[0].strip()


def finder_of_keys(text: str) -> Callable[[str], int]:
    """Return a function that tells the line of Poetry's key for a requirement."""

    def line_of(wanted: str) -> int:
        name = re.match(r"[\w.-]*", wanted)
        found = re.search(rf"^[ \t]*[\"']?{re.escape(name[0] if name else wanted)}[\"']?[ \t]*=", text, re.MULTILINE)
        return text.count("\n", 0, found.start()) + 1 if found else 1

    return line_of
