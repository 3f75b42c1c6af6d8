"""What lies in packages that no tool of ROS looks into: copies of others, and packages of the other ROS."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Protocol, TypeVar

from roslab.config.model import Kind
from roslab.decide.beside_cmake import without_packages_beside
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import made_for, of_one_ros, packages_of
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

_OF_PROGRAMS = frozenset(
    {"command", "cuda", "fetched", "framework", "gazebo", "launcher", "option", "pointed", "port", "runs", "step"}
    | {"tried", "unlaunched", "unpacked", "variable", "weights"}
)
"""Topics of what a page has people run and fetch; days and distributions say something about the whole tree."""


class _Placed(Protocol):
    @property
    def file(self) -> str: ...


Fact = TypeVar("Fact", bound=_Placed)


def of_what_is_built(evidence: Evidence, kind: Kind) -> Evidence:
    """Return the evidence without what is started, imported, included and said in such packages.

    How they are built stays: by that the packages of one ROS are told from those of the other. Nor does it have the
    packages beside a project that CMake alone builds.
    """
    evidence = without_packages_beside(evidence, kind)
    ros = kind in {"ros1", "ros2"}
    doubles = of_one_ros(packages_of(evidence), evidence, kind).doubles if ros and evidence.manifests else ()
    aside = tuple(f"{folder}/" for folder in doubles)
    if not aside:
        return evidence

    def kept(facts: Iterable[Fact]) -> tuple[Fact, ...]:
        return tuple(each for each in facts if not each.file.startswith(aside))

    return replace(
        evidence,
        requirements=kept(evidence.requirements),
        launch=kept(evidence.launch),
        programs=kept(evidence.programs),
        notebooks=tuple(file for file in evidence.notebooks if not file.startswith(aside)),
        tests=kept(evidence.tests),
        code=kept(evidence.code),
        prose=kept(evidence.prose),
        prose_pip=kept(evidence.prose_pip),
        sources=kept(evidence.sources),
        commented=kept(evidence.commented),
        mentions=tuple(
            each for each in evidence.mentions if each.topic not in _OF_PROGRAMS or not each.file.startswith(aside)
        ),
        bounds=kept(evidence.bounds),
        limits=kept(evidence.limits),
        cuda_files=tuple(file for file in evidence.cuda_files if not file.startswith(aside)),
        x86_only=kept(evidence.x86_only),
    )


def warn_of_the_other_ros(evidence: Evidence, kind: Kind) -> Iterator[Warning_]:
    """Yield a warning where no package is made for the ROS of the image, and some are for the other one."""
    ros, other = ("ROS 2", "ROS 1") if kind == "ros2" else ("ROS 1", "ROS 2")
    found = made_for(packages_of(evidence).built, evidence)
    others = [manifest for manifest, versions in found if versions and kind not in versions]
    if others and not any(kind in versions for _, versions in found):
        message = f"no package of the tree is made for {ros}, which the image has: {others[0].name} is for {other}"
        hint = f"`base.ros` in roslab.yaml names a distribution of {other}; a branch of the repository may be for {ros}"
        yield warn(f"{message}; {hint}", others[0])
