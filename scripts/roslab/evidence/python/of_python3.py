"""Programs whose first line asks for Python 3: on an Ubuntu whose ROS has Python 2 they need packages of their own."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.python.modules import Module, modules
from roslab.evidence.python.through_modules import of_tree
from roslab.knowledge.frameworks import imports
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

ROLE = "python3"
_FIRST_LINE = pattern(r"\A#![ \t]*/usr/(?:bin/env[ \t]+|(?:local/)?bin/)python3[\d.]*[ \t]*\r?\n")
ROLE_ELSEWHERE = "python3 elsewhere"
"""Of such a program whose first line names a Python 3 of the author's machine, for which the image's stands."""
_FIRST_LINE_ELSEWHERE = pattern(r"\A#![ \t]*/(?!usr/)\S{1,200}/python3[\d.]*[ \t]*\r?\n")
_OF_MODULES = {"rospy": ("python3-yaml", "python3-rospkg-modules"), "matplotlib": ("python3-tk",)}
"""What a module needs beside its own package, or instead of one: rospy is ROS's own, for either Python.

https://github.com/ros/ros_comm/blob/melodic-devel/clients/rospy/package.xml, 2026-11-27
"""
_OF_ROS = ("python3-catkin", "python3-ros", "python3-wstool", "python3-vcstool")
"""Tools, whose packages for Python 3 cannot stand beside those for Python 2, which ROS needs: rospkg's has them part.

https://github.com/ros-infrastructure/rospkg/blob/master/stdeb.cfg, 2026-11-27
"""


def of_python3(module: Module, imported: Collection[str]) -> Iterator[Dependency]:
    """Yield Ubuntu's packages for Python 3 of the modules that such a program imports, but for a test's."""
    role = _role(module)
    if role is None or places.test(module.file.path):
        return
    for top in sorted(imported):
        kept = package_of(top)
        for name in filter(None, (kept, *_OF_MODULES.get(top, ()))):
            yield Dependency(namespace="apt", name=name, strength="used", file=module.file.path, line=1, role=role)


def of_modules(repository: Repository, imported: Mapping[str, Collection[str]]) -> Iterator[Dependency]:
    """Yield the same of the modules of the tree that such programs beside packages of ROS import at their tops.

    They do so by whichever way; what several reach is of the first. ``imported``: what each file of the tree imports
    from outside of it.
    """
    followed: dict[str, set[str]] = {}
    for module in modules(repository) if repository.named("package.xml", "manifest.xml") else ():
        if (role := _role(module)) and not places.test(module.file.path):
            known = followed.setdefault(role, set())
            reached = of_tree(repository).reached((module.file.path,), known)
            known |= reached
            yield from of_python3(module, {top for file in reached for top in imported.get(file, ())})


def _role(module: Module) -> str | None:
    """Return by which first line a program runs on Python 3, ``None`` for one that may run on another."""
    if _FIRST_LINE.match(module.text):
        return ROLE
    return ROLE_ELSEWHERE if not module.names_ros and _FIRST_LINE_ELSEWHERE.match(module.text) else None


def asks_python3(module: Module) -> bool:
    """Tell whether the first line of a program asks for Python 3."""
    return _role(module) is not None


def package_of(module: str) -> str:
    """Return Ubuntu's package of a module for Python 3, ``""`` for none, or where it cannot be beside ROS's own."""
    own = (imports().get(module) or (None, None))[1] or ""
    return own if own.startswith("python3-") and not own.startswith(_OF_ROS) else ""
