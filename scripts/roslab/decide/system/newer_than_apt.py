"""Whether a page compiles a release of a library that the Ubuntu does not have yet."""

from __future__ import annotations

from roslab.decide.ros.source_names import address, fixed
from roslab.decide.system.names import Target
from roslab.evidence.dependency import Dependency, GitSource
from roslab.knowledge.code_limits import satisfies, version_of
from roslab.knowledge.recipes import recipe_at, takes_long
from roslab.values.pattern import pattern
from roslab.values.version import Version

_RELEASE = pattern(r"v?(\d+\.\d+(?:\.\d+)*)")


def newer_than_apt(asked: Dependency, target: Target, git: GitSource) -> bool:
    """Tell whether the page builds a library at a ref for what the Ubuntu does not have.

    The build requires a newer release; where no table tells which one the Ubuntu has, the page builds the very one. Or
    the build requires none, and the page has a release of a library of the table with a higher number than the
    Ubuntu's, which does not take long: its author would not compile by hand what apt has.
    """
    if asked.namespace != "cmake" or asked.strength != "declared" or not target.ubuntu:
        return False
    ros = bool(target.ros_distro)
    ref, has = fixed(git.ref) or "", version_of(asked.name, target.ubuntu, ros=ros)
    if not asked.version:
        release = _RELEASE.fullmatch(ref)
        known = recipe_at(address(git.url)) if git.configured and not git.aside else None
        if release is None or has is None or known is None or takes_long(known):
            return False
        return _numbers(release[1]) > _numbers(has)
    if has is None:
        return ref.removeprefix("v") == asked.version
    return not satisfies(asked.name, target.ubuntu, asked.version, ros=ros)


def _numbers(release: str) -> tuple[int, int]:
    version = Version(release)
    return version.major, version.minor
