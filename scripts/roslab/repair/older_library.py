"""An older Ubuntu, for code that does not fit what a newer release of a library changed."""

from __future__ import annotations

from roslab.decide.system.code_fits import brought, misfits
from roslab.explain.answer import Explanation
from roslab.knowledge.code_limits import version_of
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.repairs import repairs
from roslab.repair.change import Given, Worked
from roslab.values.version import Version


def older_library(found: Explanation, given: Given) -> Worked:
    """Take the newest Ubuntu before the image's own with the library below a release, if it has all that the code uses.

    The table's ``value`` is ``LIBRARY<RELEASE``. One that the repository builds from its source is no Ubuntu's.
    """
    library, _, below = repairs()[found.id or ""].value.partition("<")
    plan = given.plan
    if plan.ros_distro:
        return Worked(why=f"ROS {plan.ros_distro} belongs to its Ubuntu: {found.fix}")
    releases = list(ubuntus().items())
    codenames = [codename for _, codename in releases]
    if plan.ubuntu not in codenames or given.config.base.image:
        return Worked(why="the base image is no Ubuntu that `base.ubuntu` sets")
    if brought(library, given.evidence):
        return Worked(why=f"the repository builds {library} from its source: {found.fix}")
    now = version_of(library, plan.ubuntu)
    if now is None or Version(now) < Version(below):
        return Worked(why=f"the image's Ubuntu has {library} {now or 'in an unknown release'}: {found.fix}")
    older = [
        (release, codename)
        for release, codename in releases[: codenames.index(plan.ubuntu)]
        if (known := version_of(library, codename)) and Version(known) < Version(below)
    ]
    why = _unusable(older[-1], given) if older else f"no Ubuntu before it has {library} below {below}"
    if why:
        return Worked(why=f"{why}: {found.fix}")
    return Worked(values=(older[-1][0],), certain=plan.kind == "cpp")


def _unusable(ubuntu: tuple[str, str], given: Given) -> str:
    """Return what the code asks for and an Ubuntu, its release and codename, does not have; ``""`` if it has all."""
    release, codename = ubuntu
    lacking = misfits(given.evidence).get(codename)
    return f"Ubuntu {release} does not have {lacking[0]}" if lacking else ""
