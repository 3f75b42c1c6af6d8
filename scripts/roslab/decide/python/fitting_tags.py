"""Packages that pip takes from git, beside a framework of an older release: the last tag that was made for that one."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.release_tags import release_tags
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement
from roslab.values.version import Version


def fitting_tags(asked: Iterable[Requirement], held: Collection[Requirement], day: str | None) -> Iterator[Requirement]:
    """Yield the requirements, those that the table takes from git at the tag that fits what is ``held``.

    What an author takes from git himself stays. A tag that came after the ``day`` is not taken: pip clones what the
    repository was then.
    """
    for each in asked:
        row = not_on_index().get(each.key) if each.url and each.key in release_tags() else None
        tag = _tag(each.key, held, day) if row and row.instead.endswith(f" @ {each.url}") else ""
        yield replace(each, written=f"{each.written}@{tag}", url=f"{each.url}@{tag}") if tag else each


def _tag(name: str, held: Collection[Requirement], day: str | None) -> str:
    known = release_tags()[name]
    pins = (each.release for each in held if each.key == known[0].framework and each.release and not each.marker)
    release = next(pins, None)
    rows = [row for row in known if release and row.since <= Version(release)]
    return rows[-1].tag if rows and (day is None or rows[-1].released <= day) else ""
