"""Libraries that are built before what links them."""

from __future__ import annotations

from collections.abc import Container, Iterable

from roslab.config.model import Config, Source
from roslab.decide.decision import Choice
from roslab.decide.reasons import because, warn
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.source_names import address
from roslab.decide.ros.weights import Weight
from roslab.decide.system.by_everybody import BARE, told, why
from roslab.decide.system.libtorch_on_cpu import libtorch_on_cpu
from roslab.decide.system.onnx_on_cpu import onnx_on_cpu
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.recipes import licence, of_ros, recipe_at
from roslab.values.dataclass import replace


def with_recipes(
    choice: Choice[Sources],
    recipes: Iterable[tuple[Source, Dependency]],
    config: Config,
    evidence: Evidence,
    *,
    ros: bool,
) -> Choice[Sources]:
    """Put libraries from the table of recipes before the sister packages that link them.

    What the author builds is built before a library that nobody has read, where the table knows it: it is what such a
    library may need, and what the build then says to write into roslab.yaml, whose order stays.
    """
    added: dict[str, Source] = {}
    brought: set[str] = set()
    reasons = list(choice.reasons)
    warnings = list(choice.warnings)
    for source, asked in recipes:
        if source.name not in choice.answer.names and source.name not in added:
            from roslab.decide.system.unbrought_options import without_unbrought  # noqa: PLC0415 - few trees need recipes

            added[source.name], untaken = without_unbrought(source, asked)
            warnings += untaken
            brought |= _brought(asked, evidence)
            reason = f"{asked.name} is needed, and no package of this Ubuntu contains it"
            if source.place:
                reason = f"{asked.name} is needed, and {source.place.file}:{source.place.line} names its source"
            if source.unasked and (asked.namespace != "link" or asked.role == BARE):
                reason = why(source, asked)
                warnings.append(told(source, asked))
            if needed := licence(source.name):
                warnings.append(
                    warn(f"what links {source.name} starts only with {needed}, which no image brings", asked)
                )
            if ros and of_ros(recipe_at(address(source.repo or "")) or source.name):
                message = (
                    f"{source.name} {source.ref} is built beside the release that packages of ROS are compiled with"
                )
                warnings.append(warn(f"{message}: a program that passes its values to theirs may fail", asked))
            reasons.append(because("source", source.name, reason, asked, weight=Weight.RECIPE))
    warnings += (*libtorch_on_cpu(added.values(), evidence), *onnx_on_cpu(added.values(), evidence))
    first = _first(choice.answer.sources, {source.name for source in config.source})
    answer = replace(
        choice.answer,
        sources=(
            *(s for s in added.values() if not s.unread),
            *first,
            *(s for s in added.values() if s.unread),
            *(s for s in choice.answer.sources if s not in first),
        ),
        names=choice.answer.names | added.keys() | brought,
    )
    return replace(choice, answer=answer, reasons=tuple(reasons), warnings=tuple(warnings))


def _brought(asked: Dependency, evidence: Evidence) -> set[str]:
    """Return what a library that is called otherwise most likely brings: its headers, what nothing else does."""
    if asked.role != BARE and asked.namespace != "include":
        return set()
    return {asked.name.partition("/")[0]} | {each.name for project in evidence.cmake for each in project.bare}


def _first(sources: tuple[Source, ...], listed: Container[str]) -> tuple[Source, ...]:
    """Return the libraries that the table knows, and what roslab.yaml lists before one of them."""
    tabled = [each.build == "cmake" and recipe_at(address(each.repo or "")) is not None for each in sources]
    last = max((at for at, each in enumerate(sources) if tabled[at] and each.name in listed), default=-1)
    return tuple(each for at, each in enumerate(sources) if tabled[at] or (at <= last and each.name in listed))
