"""What the build of the author's own Dockerfile starts from in place of images that no longer answer."""

from __future__ import annotations

from roslab.decide.decision import Decision
from roslab.knowledge.distros import python_of_ubuntu, ubuntus_with_python2
from roslab.knowledge.os_releases import release_of
from roslab.knowledge.tools import python2_installers, python_tools
from roslab.plan.package_sources import PackageSources, sources_of
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Base:
    """An image of the author's Dockerfile, and what replaces it."""

    name: str
    """As the Dockerfile names it: the name of the build context that replaces it."""
    image: str
    """What the replacement is made from."""
    why: str
    sources: PackageSources | None
    rosdistro_tag: str | None
    """Tag of ros/rosdistro with the tables that ``rosdep update`` takes there, which still know the distribution."""
    installers: tuple[str, ...]
    """pip constraints: the last installers that run on its Pythons, whatever the Dockerfile upgrades them to."""
    recipe: str | None = None
    """The author's own Dockerfile that makes it."""
    pip_day: str | None = None
    """The day (``YYYY-MM-DD``) of what pip installs without a version, ``None`` for today's."""
    git_day: str | None = None
    """The day of what git clones without a tag or a commit, ``None`` for today's."""


def author_bases(decision: Decision) -> tuple[Base, ...]:
    """Return the replaced bases, in the order of the file."""
    from roslab.decide.mended_bases import distro_of  # noqa: PLC0415 - most trees have no Dockerfile

    found = []
    for base in decision.bases:
        release = distro_of(base.image)
        codename = release_of(base.image)
        mends = base.recipe is None and not base.answers
        found.append(
            Base(
                name=base.name,
                image=base.image,
                why=base.why,
                sources=sources_of(base.image, codename, release) if mends else None,
                rosdistro_tag=release.rosdistro_tag if release and mends else None,
                installers=(*(_installers(codename) if mends else ()), *_of_its_time(base.pip_below)),
                recipe=base.recipe,
                pip_day=base.pip_day,
                git_day=base.git_day,
            )
        )
    return tuple(found)


def _of_its_time(pip_below: str | None) -> tuple[str, ...]:
    """Return the bound of pip for what the Dockerfile has built; behind others, of which an old pip takes the first."""
    return (f'pip<{pip_below}; python_version >= "3"',) if pip_below else ()


def _installers(codename: str | None) -> tuple[str, ...]:
    """Return the bounds of Python 2 where the release has it, and those of its old Python 3."""
    python2 = python2_installers() if codename in ubuntus_with_python2() else ()
    own = python_of_ubuntu().get(codename or "")
    tools = python_tools(own, codename).installers if own else ()
    bounded = [line for line in tools if "<" in line.partition(";")[0]]
    return (
        *(f'{pin}; python_version < "3"' for pin in python2),
        *(f'{line}{" and" if ";" in line else ";"} python_version >= "3"' for line in bounded),
    )
