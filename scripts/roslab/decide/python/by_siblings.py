"""The release of a framework that a line of pip leaves open, by that of a package which the same line pins."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def by_siblings(said: Iterable[Requirement]) -> Iterator[Requirement]:
    """Yield what pages ask for, a framework in the release, and for the CUDA, of what the same line pins beside it.

    pip would take that one, for torchvision 0.14.1 requires torch 1.13.1 alone; what depends on its release knows it.
    """
    said = tuple(said)
    found: dict[tuple[str, int, str], str] = {}
    for each in said:
        from roslab.knowledge.released_with import released_with  # noqa: PLC0415 - few pages name packages

        release, _, build = (each.release or "").partition("+")
        framework, of = released_with().get((each.key, release), ("", ""))
        at = (each.file, each.line, framework)
        if of and (build or at not in found):
            found[at] = f"{of}+{build}" if build else of
    for each in said:
        release = found.get((each.file, each.line, each.key), "")
        if not release or each.specifier or each.url or each.role:
            yield each
            continue
        exact = stated(f"{each.written}=={release}")
        yield replace(each, written=exact.written, specifier=exact.specifier)
