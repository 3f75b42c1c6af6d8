"""Libraries that a page has every reader build and install, though nothing that was read asks for them by name.

The code may include their headers alone, or name their folder by a variable. A library that is missing costs the image,
and one that is not needed only minutes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from roslab.config.model import Kind, Source
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import address, plain
from roslab.decide.system.names import Target
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.libraries import header, packaged
from roslab.knowledge.recipes import recipe_at
from roslab.knowledge.released import released
from roslab.values.pattern import pattern

PAGES = (".md", ".rst", ".txt", "README", "INSTALL")
"""How the names of pages end. A script may clone for one robot or another; a page says what everybody needs."""
BARE = "bare"
"""Role of a name that is linked and that nothing else is known to bring."""
_KINDS: frozenset[Kind] = frozenset({"ros1", "ros2", "cpp"})
_TOOLS = ("cmake", "git")
"""What the image compiles with, by names that are those of their repositories, too."""
_AFFIXES = pattern(r"^lib(?=[a-z])|(?:-|_)dev$|(?<=[a-z]{3})lib$")
"""``lib`` may stand at either end of a library's name: its headers lie in ``cdd`` where it is called ``cddlib``."""
_NUMBER = pattern(r"_?\d+$")
_LONG = 3
"""Fewest letters of a word of a name by which a folder is known."""


def why(source: Source, asked: Dependency) -> str:
    """Return why such a library is built; ``asked`` is the page, or what includes a header of it."""
    if asked.namespace == "include" and source.place:
        return f"{asked.file} includes {asked.name}, and {source.place.file} installs what is called so"
    if asked.role == BARE and source.place:
        return (
            f"{asked.file} links {asked.name}, which nothing known brings, and {source.place.file} installs it before"
        )
    return f"{asked.file} has everybody build it"


def told(source: Source, asked: Dependency) -> Warning_:
    """Return the warning about such a library."""
    message = f"{source.repo} is built because {why(source, asked)}, though nothing that was read asks for it by name: "
    then = "where that fails, the image is made without it; give it under `source` in roslab.yaml if it is needed"
    return warn(f"{message}{then}", asked)


def named_in(projects: Iterable[CMakeProject]) -> Iterator[str]:
    """Yield what CMake names: it is in the tree, or what asks for it tells whether it is needed."""
    for project in projects:
        yield from (asked.name for asked in project.dependencies)
        if project.name:
            yield project.name


def headers_of(evidence: Evidence) -> Mapping[str, Dependency]:
    """Return the headers that the code includes and no table knows, by their folders or, without one, their own names.

    ``g2o`` of ``g2o/core/factory.h``, ``pidcontroller`` of ``PIDController.h``.
    """
    found: dict[str, Dependency] = {}
    for each in evidence.code:
        sure = each.namespace == "include" and each.strength == "used" and not places.aside(each.file)
        folder, inside, _ = each.name.partition("/")
        if sure and folder != ".." and header(each.name, None) is None:
            found.setdefault(_run_together(folder if inside else folder.rpartition(".")[0]), each)
    return found


def includes(git: GitSource, headers: Mapping[str, Dependency]) -> Dependency | None:
    """Return what includes a header of a library: it, or the folder that it lies in, has the library's name."""
    recipe = recipe_at(address(git.url))
    return headers.get(_run_together(git.name)) or headers.get(_run_together(recipe or git.name))


def includes_inside(git: GitSource, evidence: Evidence) -> Dependency | None:
    """Return what includes a header of a plugin, whose folders have each word of its name: ``sim/robots/acme/a.h``.

    Such a library (``sim-acme``) installs its headers among those of the one that it extends.
    """
    words = [word for word in plain(git.name).split("_") if len(word) >= _LONG]
    if len(words) < 2:
        return None
    for each in evidence.code:
        sure = each.namespace == "include" and each.strength == "used" and not places.aside(each.file)
        folders = each.name.lower().split("/")[:-1] if sure else []
        if folders[:1] == words[:1] and {*words[1:]} <= {*folders[1:]}:
            return each
    return None


def built_by_everybody(
    git: GitSource, kind: Kind, target: Target, taken: Iterable[str], *, included: bool = False, lacking: bool = False
) -> bool:
    """Tell whether a page at the root has everybody compile and install a library that comes from nowhere else.

    ``taken``: names of what the image has, and of what CMake names. What the Ubuntu or the distribution has a package
    of is none of these: were it needed, the code would ask for it by a name that the tables know, unless the code is
    known to include its headers. Where it does, or where the build is ``lacking`` a library that it links, what the
    author's CI installs counts, too, and what a Makefile alone installs, as drivers are that no code needs.
    """
    wanted = included or lacking
    written = git.file.endswith(PAGES) and "/" not in git.file
    if (
        kind not in _KINDS
        or git.kind != "clone"
        or git.aside
        or not (written or (wanted and git.file.endswith(places.OF_CI)))
    ):
        return False
    if not git.installed or not (git.configured or (wanted and git.by_make)):
        return False
    there = {*taken, *_TOOLS}
    if not included:
        there |= {*packaged(target.ubuntu), *released(target.ros_distro or "")}
    known = {_bare(name) for name in there}
    names = {_bare(git.name), _bare(recipe_at(address(git.url)) or git.name)}
    return not any(_same(name, each) for name in names for each in known)


def _bare(name: str) -> str:
    return plain(_AFFIXES.sub("", _AFFIXES.sub("", name.lower())))


def _run_together(name: str) -> str:
    return _bare(name).replace("_", "")


def _same(name: str, known: str) -> bool:
    """Tell whether two names are of one library: ``ceres-solver``, ``libceres-dev``; ``eigen``, ``libeigen3-dev``."""
    if name == known or _NUMBER.sub("", name) == _NUMBER.sub("", known):
        return True
    return name.startswith(f"{known}_") or known.endswith(f"_{name}")
