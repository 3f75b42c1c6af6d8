"""Cloned packages that the author has the build pass over: a page or a Dockerfile puts a marker into their folders."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Choice, Reason
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.source_names import plain
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import replace

WEIGHT = 60


def by_author(evidence: Evidence) -> Iterator[Mention]:
    """Yield where pages at the root and the project's own Dockerfiles put such a marker, or CI does."""
    own = {each.file for each in evidence.dockerfiles if each.purpose == "project"}
    for mention in evidence.mentions:
        page = mention.source == "readme" and "/" not in mention.file
        if mention.topic == "skipped" and (page or mention.source == "ci" or mention.file in own):
            yield mention


def with_marks(sources: Choice[Sources], evidence: Evidence) -> Choice[Sources]:
    """Return the sources, each with the folders of it that are marked, ``""`` for all of it."""
    marked: dict[str, dict[str, Mention]] = {}
    for mention in by_author(evidence):
        parts = mention.value.split("/") if mention.source != "ci" else []
        for source in sources.answer.sources:
            at = next((index for index, part in enumerate(parts) if plain(part) == plain(source.name)), None)
            if at is not None and source.build != "cmake":
                marked.setdefault(source.name, {}).setdefault("/".join(parts[at + 1 :]), mention)
    if not marked:
        return sources
    given = tuple(
        replace(source, marked=tuple(marked[source.name])) if source.name in marked else source
        for source in sources.answer.sources
    )
    reasons = tuple(_reason(name, folder, said) for name, there in marked.items() for folder, said in there.items())
    return replace(sources, answer=replace(sources.answer, sources=given), reasons=(*sources.reasons, *reasons))


def _reason(name: str, folder: str, said: Mention) -> Reason:
    why = (
        f"{folder} in it is not built: the author has the build pass over it"
        if folder
        else ("it is not built: the author has the build pass over it")
    )
    return because("source", name, why, said, weight=WEIGHT)
