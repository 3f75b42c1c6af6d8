"""Libraries without which CMake goes on, and the compiler does not: the code includes their headers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.needs import code_needs
from roslab.decide.system.required import own_names, similar
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence


def included(asked: Dependency, evidence: Evidence) -> Dependency | None:
    """Return the first header of a library that CMake only tries to find, in the folder of the project that asks.

    The header's folder has the library's name: ``caffe/caffe.hpp`` of ``find_package(Caffe)``.
    """
    if asked.namespace != "cmake" or asked.strength != "used" or asked.condition or asked.role == "test":
        return None
    folder, begins = asked.file.rpartition("/")[0], f"{asked.name.lower()}/"
    for each in evidence.code:
        inside = not folder or each.file.startswith(f"{folder}/")
        sure = each.namespace == "include" and each.strength == "used" and not places.aside(each.file)
        if sure and inside and each.name.lower().startswith(begins):
            return each
    return None


def without_tried(
    evidence: Evidence, packages: Packages, target: Target, provided: Iterable[str], build_tool: str
) -> Iterator[Warning_]:
    """Yield a warning for each such library of which nothing that is ``provided`` has the headers."""
    said = [*evidence.prose, *(each for made in evidence.dockerfiles for each in made.dependencies)]
    apt = {each.name for each in said if each.namespace == "apt" and not each.name.endswith("-dev")}
    names = {plain(name) for name in provided if name not in apt or name.startswith("ros-")}
    own, told = own_names(evidence, packages), set[str]()
    for asked in code_needs(evidence, packages):
        if asked.name in told or asked.name in own or resolve(asked, target).known:
            continue
        header = included(asked, evidence)
        if header and not similar(plain(asked.name), names):
            told.add(asked.name)
            message = f"the code includes {header.name}, and nothing is known that brings {asked.name}, without which "
            then = f"CMake goes on: {build_tool} stops where that is compiled; give its repository under `source` in"
            yield warn(f"{message}{then} roslab.yaml", header)
