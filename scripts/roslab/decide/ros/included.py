"""Packages of ROS whose messages the code includes or imports.

Their headers and modules are generated, so that the package must be built.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import OF_MESSAGES, plain
from roslab.decide.ros.workspace import Packages
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.native.generated import package_of
from roslab.knowledge.frameworks import imports
from roslab.knowledge.libraries import header
from roslab.values.dataclass import replace

ROLE = "include"
MESSAGES = "messages"
"""Role of a module of which messages, services or actions are imported."""


def included(evidence: Evidence, packages: Packages) -> Iterator[Dependency]:
    """Yield each package of whose messages code of the built packages includes a header, under no condition."""
    told: set[str] = set()
    for name, each in generated_headers(evidence, packages):
        if name not in told:
            told.add(name)
            yield Dependency(namespace="ros", name=name, strength="declared", file=each.file, line=each.line, role=ROLE)


def generated_headers(evidence: Evidence, packages: Packages) -> Iterator[tuple[str, Dependency]]:
    """Yield each include of such a header, with the package of its message; none of the tree's own."""
    folders = tuple(manifest.file.rpartition("/")[0] for manifest in packages.built)
    for each in evidence.code:
        name = package_of(each.name) if each.namespace == "include" and each.strength != "optional" else ""
        if not name or name in packages.names or places.aside(each.file) or header(each.name, None):
            continue
        if any(not folder or each.file.startswith(f"{folder}/") for folder in folders):
            yield name, each


def without_headers(
    evidence: Evidence,
    packages: Packages,
    there: AbstractSet[str],
    tried: Mapping[str, str],
    *,
    build_tool: str,
    cloned: bool,
) -> Iterator[Warning_]:
    """Yield a warning for each of them, and each imported, that nothing brings and neither a manifest nor CMake names.

    ``there``: names that something brings, also in one spelling; ``tried``: where the build looks for packages;
    ``cloned``: repositories are cloned whose packages are not known.
    """
    named = {d.name for manifest in packages.built for d in manifest.dependencies}
    named |= {d.name for project in evidence.cmake for d in project.dependencies}
    for asked in included(evidence, packages):
        if asked.name in named or not there.isdisjoint((asked.name, plain(asked.name))):
            continue
        where = tried.get(asked.name)
        perhaps = "one of the cloned repositories may hold it" if cloned else ""
        perhaps = f"the build looks for it in {where}" if where else perhaps
        what = f"the code includes messages of {asked.name}, which no package.xml asks for and no table knows"
        where_not = f"{perhaps}, and where it is not there, " if perhaps else ""
        hint = "give its repository under `source` in roslab.yaml"
        yield warn(f"{what}: {where_not}{build_tool} will stop where that is compiled; {hint}", asked)
    for asked in _imported(evidence, packages):
        if asked.name in named or not there.isdisjoint((asked.name, plain(asked.name))):
            continue
        where = tried.get(asked.name)
        perhaps = "one of the cloned repositories may hold them, and else " if cloned else ""
        perhaps = f"the build looks for it in {where}, and where it is not there, " if where else perhaps
        what = f"the code imports messages of {asked.name}, which no package.xml asks for and no table knows"
        hint = "give its repository under `source` in roslab.yaml"
        yield warn(f"{what}: {perhaps}what imports them stops; {hint}", asked)


def imported(evidence: Evidence, packages: Packages) -> Iterator[Dependency]:
    """Yield each package whose messages, services or actions Python in the built packages imports, as one of ROS."""
    for each in _imported(evidence, packages):
        yield replace(each, namespace="ros", strength="declared", role="exec")


def _imported(evidence: Evidence, packages: Packages) -> Iterator[Dependency]:
    """Yield the first import of each package of messages by Python in the built packages, under no condition."""
    folders = tuple(manifest.file.rpartition("/")[0] for manifest in packages.built)
    by_pip = {plain(asked.key) for file in evidence.requirements for asked in file.requirements}
    by_pip |= {plain(asked.key) for asked in evidence.prose_pip}
    told: set[str] = set(packages.names)
    for each in evidence.code:
        if plain(each.name) in by_pip:
            continue
        of_ros = each.role == MESSAGES or each.name.endswith(OF_MESSAGES)
        sure = each.namespace == "import" and each.strength == "used" and of_ros
        if not sure or each.name in told or places.aside(each.file) or each.name in imports():
            continue
        if any(not folder or each.file.startswith(f"{folder}/") for folder in folders):
            told.add(each.name)
            yield each
