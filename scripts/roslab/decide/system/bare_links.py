"""Libraries that CMake links by names of which nothing that was read says what brings them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Collection, Iterator, Mapping

from roslab.config.model import Kind
from roslab.decide.decision import Unlinkable, Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.built import Built
from roslab.decide.system.required import reached, similar
from roslab.decide.system.shown_headers import headers_by_name, shown_by
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.libraries import header
from roslab.values.dataclass import replace

_SHORTEST = 3
"""Fewest letters by which the first word of a name tells what brings it: ``pcl_common``."""
_PLUGIN = "Plugin"
"""How the libraries of Gazebo's sensors end: https://github.com/gazebosim/gazebo-classic/tree/gazebo11/plugins."""


def bare_links(evidence: Evidence, packages: Packages, kind: Kind) -> Iterator[tuple[str, Dependency]]:
    """Yield each package, or the program, with the first place where it always links such a library.

    Not where the tree names something that is called alike, nor where a submodule, or what CMake fetches, may make it.
    """
    if not any(project.bare for project in evidence.cmake):
        return
    if any(git.kind == "submodule" and git.absent for git in evidence.sources):
        return
    alike = {*_named(evidence)}
    told: set[str] = {*_with_headers(evidence)}
    for package, project in reached(evidence, packages, kind):
        for asked in () if project.sources or project.brought else project.bare:
            if asked.name not in told and not _family(asked.name, alike):
                told.add(asked.name)
                yield package, asked


def as_packages(evidence: Evidence, packages: Packages, kind: Kind) -> Iterator[Dependency]:
    """Yield them as packages of ROS: in a workspace, the author's other code may make one."""
    if kind in {"ros1", "ros2"}:
        for _, asked in bare_links(evidence, packages, kind):
            yield replace(asked, namespace="ros", strength="declared", role="link")


def without_linked(
    evidence: Evidence, packages: Packages, built: Built, may_hold: Callable[[str], bool], tried: Mapping[str, str]
) -> Iterator[tuple[str, Warning_]]:
    """Yield the file that links each of them, with a warning; of those that a header shows, another one tells.

    ``may_hold``: whether what is cloned may be of a name; ``tried``: where the build looks for packages.
    """
    headers = headers_by_name(evidence)
    for package, asked in bare_links(evidence, packages, built.kind):
        name = asked.name
        known = built.target.knows(name) or may_hold(name) or _family(name, built.names)
        known = known or (name not in tried and bool(shown_by(asked, headers)))
        if package in built.out or known:
            continue
        where = f"; the build looks for it in {tried[name]}, and where it is not there," if name in tried else ":"
        what = f"{package} links {name}, which nothing in the tree makes and nothing is known to bring"
        then = "give its repository under `source` or its package under `apt` in roslab.yaml"
        said = warn(f"{what}{where} {built.build_tool} will most likely stop there; {then}", asked)
        unlinkable = Unlinkable(message=said.message, file=said.file, line=said.line)
        yield asked.file, said if name in tried else unlinkable


def _family(name: str, names: Collection[str]) -> bool:
    """Tell whether something has the first word of a name in its own: ``libpcl-dev`` of ``pcl_common``."""
    word = re.split(r"[^a-z]", name.lower(), maxsplit=1)[0]
    gazebo = name.endswith(_PLUGIN) and similar("gazebo", names)
    return gazebo or similar(plain(name), names) or (len(word) >= _SHORTEST and similar(word, names))


def _with_headers(evidence: Evidence) -> Iterator[str]:
    """Yield the names of the headers that the code includes and that a table knows: their package has the library.

    ``cgraph`` of ``graphviz/cgraph.h``.
    """
    for each in evidence.code:
        if each.namespace == "include" and each.strength == "used" and header(each.name, None):
            yield posixpath.basename(each.name).partition(".")[0]


def _named(evidence: Evidence) -> Iterator[str]:
    """Yield what the tree asks for by other means than linking it, in one spelling."""
    asked: list[Dependency] = [d for each in evidence.cmake for d in each.dependencies if d.namespace != "link"]
    asked += [d for each in evidence.manifests for d in each.dependencies]
    yield from (plain(each.name) for each in asked)
    yield from (plain(git.name) for git in evidence.sources if git.kind not in {"link", "clone"})
    yield from (plain(name) for project in evidence.cmake for name in project.made)
