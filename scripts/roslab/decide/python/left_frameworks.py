"""Frameworks that an image of ROS goes without, since none of its nodes imports them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.python.guesses import FRAMEWORKS
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import build_needs, imports
from roslab.knowledge.guesses import same_module
from roslab.knowledge.often_brought import all_brought, framework_users
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


def left_frameworks(evidence: Evidence, kind: Kind, asked: Iterable[Requirement]) -> Iterator[Warning_]:
    """Yield a warning for each framework that code of the tree imports and nothing installs; ``asked``: of pip.

    Where one of them is installed, by another package too, another is another way to do the same.
    """
    names = {each.key for each in asked}
    names |= {name for key in names for name in _brought(key)}
    if kind not in {"ros1", "ros2"} or names & FRAMEWORKS:
        return
    keys = {key.name for manifest in packages_of(evidence).built for key in manifest.dependencies}
    for each in evidence.code:
        if each.namespace != "import" or each.role == "node" or each.strength != "used" or places.aside(each.file):
            continue
        package, _ = imports().get(each.name) or (None, None)
        name = canonicalize_name(package) if package else ""
        if (
            name not in FRAMEWORKS
            or any(same_module(name, other) for other in names)
            or any(name in key for key in keys)
        ):
            continue
        message = f"nothing asks for {name} by its name: no node of the tree imports it, only code beside them"
        yield warn(f"{message}; if that is to run in the image, give {name} under `pip` in roslab.yaml", each)


def _brought(key: str) -> Iterator[str]:
    """Yield the frameworks that come with a package, or that are there before it is built."""
    found = {framework_users().get(key, ""), *all_brought().get(key, ()), *build_needs().get(key, ())}
    yield from sorted(found & FRAMEWORKS)
