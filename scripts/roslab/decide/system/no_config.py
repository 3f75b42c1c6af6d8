"""Components of catkin for which no package has a configuration file of that name: ``opencv2``, ``Eigen``."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.dependency import Dependency
from roslab.evidence.native.cmake_needs import COMPONENT
from roslab.knowledge.table import row


def without_config(asked: Dependency, kind: Kind) -> bool:
    """Tell whether catkin looks for a configuration file that is called otherwise: it takes no module in its place."""
    component = asked.namespace == "ros" or asked.role == COMPONENT
    return kind == "ros1" and component and asked.required and row("no_config", asked.name) is not None


def told_configs(warnings: Iterable[Warning_], unmet: Iterable[tuple[str, Dependency]], kind: Kind) -> list[Warning_]:
    """Return the warnings with the name that CMake knows of each, in place of that nothing is known to bring it."""
    told: dict[str, Warning_] = {}
    for package, asked in unmet:
        found = row("no_config", asked.name) if without_config(asked, kind) else None
        if found:
            message = f"{package} asks catkin for the component {asked.name}, whose configuration file is called"
            hint = f"{found['config']}Config.cmake, and stops there: write find_package({found['config']} REQUIRED)"
            told.setdefault(asked.name, warn(f"{message} {hint}", asked))
    unknown = tuple(f"nothing is known that brings {name}," for name in told)
    return [*(each for each in warnings if not each.message.startswith(unknown)), *told.values()]
