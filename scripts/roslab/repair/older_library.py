"""An older Ubuntu, for code that does not fit what a newer release of a library changed."""

from __future__ import annotations

from roslab.explain.answer import Explanation
from roslab.knowledge.code_limits import fits, version_of
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.repairs import repairs
from roslab.repair.change import Given, Worked
from roslab.values.version import Version


def older_library(found: Explanation, given: Given) -> Worked:
    """Take the newest Ubuntu before the image's own with the library below a release, if it has all that the code uses.

    The table's ``value`` is ``LIBRARY<RELEASE``. One that the build makes itself is no Ubuntu's.
    """
    library, _, below = repairs()[found.id or ""].value.partition("<")
    plan = given.plan
    if plan.ros_distro:
        return Worked(why=f"ROS {plan.ros_distro} belongs to its Ubuntu: {found.fix}")
    releases = list(ubuntus().items())
    codenames = [codename for _, codename in releases]
    if plan.ubuntu not in codenames or given.config.base.image:
        return Worked(why="the base image is no Ubuntu that `base.ubuntu` sets")
    now = version_of(library, plan.ubuntu)
    if now is None or Version(now) < Version(below):
        return Worked(why=f"the image's Ubuntu has {library} {now or 'in an unknown release'}: {found.fix}")
    older = [
        (release, codename)
        for release, codename in releases[: codenames.index(plan.ubuntu)]
        if (known := version_of(library, codename)) and Version(known) < Version(below)
    ]
    for release, codename in older[-1:]:
        lacking = next(
            (each for each in given.evidence.limits if not _has(each.library, codename, each.at_least)), None
        )
        if lacking is None:
            return Worked(values=(release,), certain=plan.kind == "cpp")
        return Worked(why=f"Ubuntu {release} has no {lacking.library} {lacking.at_least} ({lacking.what}): {found.fix}")
    return Worked(why=f"no Ubuntu before it has {library} below {below}")


def _has(library: str, ubuntu: str, at_least: str | None) -> bool:
    return fits(library, ubuntu, at_least=at_least, below=None)
