"""Changes by ``sed`` that the author makes to what he builds from its source."""

from __future__ import annotations

import shlex
from collections.abc import Iterator

from roslab.config.model import Source
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.source_names import plain
from roslab.decide.sections import about_trouble
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import replace

WEIGHT = 60
_SOURCES = frozenset({"readme", "script"})


def with_edits(sources: Choice[Sources], evidence: Evidence) -> Choice[Sources]:
    """Return what is built from source with these changes, each told among the reasons.

    Where one does not fit, as a release has no such file, that is told and the build goes on.
    """
    found = {each.name: _edits(each, evidence) for each in sources.answer.sources if not each.listed}
    if not any(found.values()):
        return sources
    changed = tuple(_with(each, found.get(each.name, {})) for each in sources.answer.sources)
    reasons = tuple(
        because("source", name, f"the author changes {', '.join(files)} in it by sed", mention, weight=WEIGHT)
        for name, edits in found.items()
        for mention, files in edits.values()
    )
    answer = replace(sources.answer, sources=changed)
    return replace(sources, answer=answer, reasons=(*sources.reasons, *reasons))


def _edits(source: Source, evidence: Evidence) -> dict[str, tuple[Mention, tuple[str, ...]]]:
    """Return the calls that change files of a library, in its folder, each with who makes it and these files."""
    found: dict[str, tuple[Mention, tuple[str, ...]]] = {}
    name = plain(source.name)
    for mention in _said(evidence):
        words = shlex.split(mention.value)
        end = words.index("--")
        files = [_inside(name, file) for file in words[end + 1 :]]
        named = tuple(file for file in files if file)
        if named and len(named) == len(files):
            found.setdefault(shlex.join((*words[: end + 1], *named)), (mention, named))
    return found


def _said(evidence: Evidence) -> Iterator[Mention]:
    """Yield the calls of the author's own Dockerfiles, pages and scripts, those of one file in their order."""
    for docker in evidence.dockerfiles:
        if docker.purpose == "project":
            yield from (each for each in docker.patches if each.topic == "edited")
    for each in evidence.mentions:
        own = each.source in _SOURCES and not places.vendored(each.file)
        if each.topic == "edited" and own and not about_trouble(each.heading):
            yield each


def _inside(name: str, file: str) -> str:
    """Return the path of a file in the folder of a clone, ``""`` where it lies elsewhere.

    A library may have a folder of its own name below: the first one is its clone's.
    """
    parts = file.split("/")
    return next(("/".join(parts[at + 1 :]) for at, part in enumerate(parts[:-1]) if plain(part) == name), "")


def _with(source: Source, edits: dict[str, tuple[Mention, tuple[str, ...]]]) -> Source:
    steps = [source.prepare] if source.prepare else []
    for call, (mention, _) in edits.items():
        told = shlex.quote(f"roslab: left out: {source.name} is not changed as by {mention.file}:{mention.line}")
        steps.append(f"{{ {call} || echo {told}; }}")
    return replace(source, prepare=" && ".join(steps)) if edits else source
