"""The keys of rosdep whose packages apt does not install: skipped, so that the others are installed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.explain.answer import Explanation
from roslab.knowledge.released import released
from roslab.repair.change import Given, Worked


def key(found: Explanation, given: Given) -> Worked:
    """Skip the key whose package apt does not have."""
    names = dict(found.names)
    packages = (names.get("package") or names.get("name", "")).replace(",", " ").split()
    if "rosdep" not in found.step:
        return Worked(why=found.fix)
    keys = tuple(_keys(packages, given))
    return Worked(values=keys, why="" if keys else f"no key of a package.xml stands for {', '.join(packages)}")


def of_double(found: Explanation, given: Given) -> Worked:
    """Skip the key whose package holds the files of another package of the same ROS, which is installed."""
    names = dict(found.names)
    package, other = names.get("package", ""), names.get("other", "")
    prefix = f"ros-{given.plan.ros_distro}-"
    if "rosdep" not in found.step or not (package.startswith(prefix) and other.startswith(prefix)):
        return Worked(why=found.fix)
    return Worked(values=tuple(_keys([package], given)), why=found.fix)


def _keys(packages: Iterable[str], given: Given) -> Iterator[str]:
    """Yield the keys that packages stand for: of the repository, else of ROS, where one that is cloned asks."""
    distro = given.plan.ros_distro or ""
    for package in packages:
        wanted = [known for known in given.plan.rosdep_keys if _is(package, known)]
        name = package.removeprefix(f"ros-{distro}-").replace("-", "_")
        if not wanted and package.startswith(f"ros-{distro}-") and name in released(distro):
            wanted = [name]
        yield from wanted


def _is(package: str, key: str) -> bool:
    return package == key or package.endswith(f"-{key.replace('_', '-')}")
