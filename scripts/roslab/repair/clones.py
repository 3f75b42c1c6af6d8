"""What is missing and lies in a repository that a table or the tree names: the next build clones it, by ``source``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import get_args

from roslab.config.model import Source, SourceBuild
from roslab.config.source import flow
from roslab.decide.ros.source_names import address, fixed, plain
from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.evidence.ros.vcs import https
from roslab.explain.answer import Explanation
from roslab.knowledge.distros import distro
from roslab.knowledge.released import released
from roslab.knowledge.repairs import CLONES
from roslab.knowledge.ros_sources import RosSource, ros_sources
from roslab.repair.change import Given, Worked
from roslab.values.dataclass import replace

_NAMES = ("name", "header", "module", "library")
"""What a failure captures of something that a repository may hold."""
_BY_NAME = ("vcs", "git_url", "clone", "upstream", "fetch", "link")
"""What names a repository that can be cloned: not a submodule, which lies in the tree, nor a part of it."""


def brought(found: Explanation, given: Given) -> Worked | None:
    """Return the package of ROS, or the repository, that has the name of what a failed step lacks.

    Of a header that is its first folder, as ROS's packages lay theirs down.
    """
    names = dict(found.names)
    said = [word for key in _NAMES for word in names.get(key, "").split(", ") if word]
    if not said or given.plan.author_dockerfile:
        return None
    words = list(dict.fromkeys(word.partition("/")[0] if "/" in word else word.partition(".")[0] for word in said))
    if not {each.name for each in given.evidence.manifests}.isdisjoint(words):
        return None  # the repository's own: it is built later, or does not lay it down
    ros = given.plan.ros_distro
    new = [word for word in words if ros and word in released(ros) and word not in given.plan.rosdep_keys]
    packages = tuple(f"ros-{ros}-{word.replace('_', '-')}" for word in new)
    if packages := tuple(each for each in packages if each not in (*given.plan.apt, *given.plan.apt_guessed)):
        return Worked(key="apt", values=packages)
    worked = cloned(words, given)
    if worked is None or names.get("name"):
        return worked
    return replace(worked, certain=all(surely(git, given) for word in words if (git := named(word, given))))


def of_package(found: Explanation, given: Given) -> Worked:
    """Return the package of ROS that a failed step lacks; not one of the repository, or that the image has already."""
    return brought(found, given) or Worked(why=found.fix)


def surely(git: GitSource, given: Given) -> bool:
    """Tell whether the tree has its reader install a repository, or has it of its own owner, and more than links to it.

    A folder of headers or a module may have the name of a repository that is another one.
    """
    here = address(given.evidence.origin or "")
    of_owner = bool(here) and address(git.url).rpartition("/")[0] == here.rpartition("/")[0]
    return of_owner or git.kind != "link" or bool(git.holds or git.told or git.to_install)


def cloned(words: Iterable[str], given: Given) -> Worked | None:
    """Return the repositories that hold packages, as values of ``source``; ``None`` where no name leads to one.

    First one of the package's name that the tree names, then what the table knows for this distribution of ROS.
    """
    lines = {place: line for word in words for place, line in _lines(word, given)}
    return Worked(key=CLONES, values=tuple(lines.values())) if lines else None


def tabled(word: str, given: Given) -> tuple[RosSource, ...]:
    """Return the table's repositories for a package and what that needs, for the distribution of ROS in the image."""
    ros = given.plan.ros_distro
    known = distro(ros)
    return ros_sources(word, known.ros, ros) if ros and known else ()


def named(word: str, given: Given) -> GitSource | None:
    """Return the repository of a package's name that the tree names, ``None`` where the build has it already.

    Nor what the distribution of ROS in the image released: its packages fit each other, and a clone may not fit them.
    """
    if given.plan.ros_distro and word in released(given.plan.ros_distro):
        return None
    there = {address(each.repo) for each in _cloned_already(given) if each.repo}
    own = next((each for each in given.evidence.sources if _called(each, word)), None)
    return own if own and address(own.url) not in there else None


def _lines(word: str, given: Given) -> Iterator[tuple[str, str]]:
    """Yield the lines of the repositories that hold a package, by their addresses; none that the build clones already.

    Nor what has to be changed before it is a package, or needs more than a clone: no line of roslab.yaml says that.
    """
    build = given.plan.workspace.ros.tool if given.plan.workspace.ros else "cmake"
    if build not in get_args(SourceBuild):
        return
    if own := named(word, given):
        yield address(own.url), flow(word, https(own.url), ref=fixed(own.ref), build=build)
        return
    there = {address(each.repo) for each in _cloned_already(given) if each.repo}
    known = [row for row in tabled(word, given) if address(row.repo) not in there]
    if any(row.prepare or row.library or row.cmake for row in known):
        return
    for row in known:
        options = row.options.format(distro=given.plan.ros_distro)
        yield address(row.repo), flow(row.package, row.repo, ref=row.ref, build=build, options=options)


def _cloned_already(given: Given) -> Iterator[Source]:
    plan = given.plan
    yield from (*plan.libraries, *plan.workspace.sources, *plan.workspace.submodules, *given.config.source)


def _called(git: GitSource, word: str) -> bool:
    """Tell whether the tree names a repository that anybody may clone by the name of a package."""
    aside = places.vendored(git.file) or places.test(git.file) or git.private or git.doubt or git.itself or git.taken
    return git.kind in _BY_NAME and not aside and plain(git.name) == plain(word)
