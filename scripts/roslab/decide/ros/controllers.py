"""Keys that are the names of controllers in the tree's own parameter files: what brings one is its type's package."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from roslab.decide.reasons import warn
from roslab.decide.ros.keys import Translated
from roslab.decide.system.names import Target
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import ever_released, rosdep_keys


def controllers(keys: Iterable[Dependency], evidence: Evidence) -> dict[str, Dependency]:
    """Return the controllers that keys are called like, which no distribution released and rosdep does not have.

    Of a repository that a page clones or links to, or that roslab.yaml has, a package may be called so, too: ``keys``
    are those that none of them is taken for.
    """
    named = {each.name: each for each in evidence.code if each.namespace == "controller"}
    names = (key.name for key in keys if key.name in named)
    return {name: named[name] for name in names if not ever_released(name) and name not in rosdep_keys()}


def of_controller(key: Dependency, named: Mapping[str, Dependency], target: Target) -> Translated | None:
    """Return what to do about a key that is one of them; the package of its type is installed where ROS has it."""
    controller = named.get(key.name)
    if controller is None:
        return None
    there = target.knows(controller.role)
    what = f"{key.name} is a controller of {controller.file}, not a package: its type is of {controller.role}"
    then = ", which is installed for it" if there else ""
    guessed = (target.ros(controller.role),) if there else ()
    return Translated(guessed=guessed, skip=True, warning=warn(f"{what}{then}", key))
