"""Packages of the repository that most likely cannot be built, for nothing is known to bring what they are built with.

What is cloned may hold it, so that they are tried, but they must not stop all others.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator

from roslab.decide.programs import owner
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.included import included
from roslab.decide.ros.nowhere import nowhere
from roslab.decide.ros.source_names import plain, telling_words
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import needing
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.required import asking, required
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import released, rosdep_keys


def may_fail(
    evidence: Evidence,
    packages: Packages,
    target: Target,
    sources: Sources,
    left_out: Collection[str],
    *,
    stopping: Collection[str] = (),
) -> tuple[str, ...]:
    """Return the packages that CMake or the compiler will stop in where no clone has what they need.

    With those that need them; none where no others are left. What a clone is called like is most likely in that.
    ``stopping``: files of CMake or code that look for a library which nothing brings.
    """
    if not target.ros_distro:
        return ()
    found: dict[str, None] = {}
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    tried = (source.name for source in sources.sources if source.unasked and source.build == "cmake")
    stopped = [name for file in stopping if (name := owner(file, folders))]
    stopped += (name for by in asking(evidence, packages, tried).values() for name in by)
    for package in dict.fromkeys((*_stopped(evidence, packages, _known(packages, target, sources), target), *stopped)):
        found |= dict.fromkeys(needing(package, packages))
    names = tuple(name for name in found if name not in left_out)
    others = [m for m in packages.built if m.name not in {*names, *left_out} and not m.metapackage]
    return names if others else ()


def _known(packages: Packages, target: Target, sources: Sources) -> Callable[[str], bool]:
    """Return whether something is known to bring a name, or is called like it.

    That is no submodule that is not there, nor a clone that only some page names: the image goes without what cannot be
    cloned.
    """
    names = released(target.ros_distro or "") | rosdep_keys() | packages.names | sources.names
    unsure = {each for source in sources.sources if source.unasked for each in (source.name, plain(source.name))}
    names -= unsure
    clones = [source.name for source in sources.sources if not source.unasked]
    words = {word for name in clones for word in telling_words(name)} | {plain(name) for name in clones}
    return lambda name: name in names or bool(words & (telling_words(name) | {plain(name)}))


def _stopped(evidence: Evidence, packages: Packages, known: Callable[[str], bool], target: Target) -> Iterator[str]:
    """Yield the packages of which CMake requires, or the code includes, what nothing is known to bring."""
    keyed = {d.name for m in packages.built for d in m.dependencies if d.role not in {"test", "doc"}}
    for package, asked in required(evidence, packages):
        if (asked.namespace == "ros" or asked.name in keyed) and _nowhere(asked, known, target):
            yield package
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    for asked in included(evidence, packages):
        if not known(asked.name) and (name := owner(asked.file, folders)):
            yield name
    yield from nowhere(evidence, packages, known)


def _nowhere(asked: Dependency, known: Callable[[str], bool], target: Target) -> bool:
    return not known(asked.name) and not resolve(asked, target).known
