"""Requirement files that a page puts into different environments: the image has one, and gets what belongs to it."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.model import Config
from roslab.decide.decision import Warning_
from roslab.decide.python.machine_lists import not_installed, of_anacondas
from roslab.decide.python.manifests import resolve
from roslab.decide.without_optional_ros import without_optional_ros
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.values.dataclass import replace

_PAGES = (".md", ".rst")


def of_other_environments(evidence: Evidence) -> frozenset[str]:
    """Return the lists that pages at the root put only into another environment than the one that is taken.

    That is the one of the requirements.txt at the root, else the first of the page. What is put into both, or into
    none, is no alternative.
    """
    by_page: dict[str, dict[str, list[str | None]]] = {}
    known = {file.file for file in evidence.requirements}
    for asked in evidence.prose_pip:
        path = resolve(asked, known) if asked.role == "file" and "/" not in asked.file else None
        if path and asked.file.endswith(_PAGES):
            environment = _environment(evidence, asked.file, asked.line)
            by_page.setdefault(asked.file, {}).setdefault(path, []).append(environment)
    return frozenset(path for lists in by_page.values() for path in _left(lists))


def _left(lists: dict[str, list[str | None]]) -> Iterator[str]:
    """Yield the lists of one page that belong to other environments; ``lists``: the environments of each, in order."""
    entered = [name for names in lists.values() for name in names if name]
    taken = next(iter([*filter(None, lists.get("requirements.txt", ())), *entered]), None)
    for path, names in lists.items():
        if taken not in names and None not in names:
            yield path


def _environment(evidence: Evidence, page: str, line: int) -> str | None:
    """Return the environment that a page is in at a line, ``None`` before the first."""
    before = [m for m in evidence.mentions if m.topic == "entered" and m.file == page and m.line <= line]
    return max(before, key=lambda mention: mention.line).value if before else None


def of_one_environment(evidence: Evidence, config: Config) -> Evidence:
    """Return the evidence in which the lists of other environments are no part of what the program needs.

    Nor is the robot's environment, where only that needs ROS, or what an Anaconda had installed. What roslab.yaml
    chooses is, whatever a page says.
    """
    evidence = without_optional_ros(evidence, config)
    others = of_other_environments(evidence) | of_anacondas(evidence)
    if not others or config.requirements is not None:
        return evidence
    files = (replace(file, purpose="dev") if file.file in others else file for file in evidence.requirements)
    return replace(evidence, requirements=tuple(files))


def left_to_others(evidence: Evidence, chosen: Collection[RequirementFile]) -> Iterator[Warning_]:
    """Yield a warning for each of these lists that is not among the chosen files."""
    why = "the page puts it into an environment of its own, beside that of the other list"
    return not_installed(evidence, of_other_environments(evidence), chosen, why)
