"""Imports of the code that nothing in the image brings: each is told, with the line that imports it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.python.firmware import without_firmware
from roslab.decide.python.guesses import known_names, told_ways
from roslab.decide.python.may_bring import (
    SHORTEST,
    absent,
    begins_like,
    declares,
    excuses,
    extras_of,
    names_there,
    of_owners,
    parts_of,
)
from roslab.decide.python.on_index import on_index
from roslab.decide.python.packages import Chosen
from roslab.decide.python.refused import refused
from roslab.decide.reasons import warn
from roslab.decide.ros.sought_addresses import public_owner
from roslab.decide.ros.sought_imports import linked_of_owner, modules_of_owner
from roslab.decide.ros.source_names import OF_MESSAGES
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.ros.vcs import https
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import ros_modules
from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.python2_packages import of_python2, system_package
from roslab.knowledge.released import ever_released
from roslab.knowledge.ros_sources import ros_sources
from roslab.values.dataclass import replace
from roslab.values.name import bare_name, canonicalize_name
from roslab.values.requirement_line import stated

_CONFIGURED = "roslab.yaml"
"""A row that says why and names it says also how to install the package."""
MOST = 8
"""Most modules that are named in one warning."""
_OF_ROS = frozenset({"ros1", "ros2"})


def lost(
    evidence: Evidence,
    kind: Kind,
    chosen: Chosen,
    ubuntu: str | None,
    ros_distro: str | None,
    *,
    brought: Collection[str] = (),
) -> Iterator[Warning_]:
    """Yield a warning for each imported module that pip's index is known to lack, and one for those of no table.

    Where a manifest declares packages, a submodule is missing, or a page has people install what it links to, the
    warning says that one of them may bring such a module, or the owner's repository in which the build looks for it.
    ``ubuntu``: the one whose own Python it is, if it is one's. ``brought``: what conda brings.
    """
    for used in _refused(evidence, chosen):
        if canonicalize_name(used.name) in brought:
            continue
        row = not_on_index()[canonicalize_name(used.name)]
        if not (row.instead or (ubuntu and system_package(used.name, ubuntu))):
            of_conda = f" from {' or '.join(row.conda)}, by an environment file" if row.conda else ""
            then = f"; install it{of_conda or ' with `pip`, `custom` or `source` in roslab.yaml'}"
            then = f"{'' if _CONFIGURED in row.why else then} ({row.source})"
            yield warn(f"the code imports {used.name}, which the index of pip does not have: {row.why}{then}", used)
    yield from _tried(chosen)
    unknown = unknown_modules(evidence, kind, chosen) or [*_of_nodes(evidence, kind, chosen, ros_distro)]
    lacking = {m.value: m for m in evidence.mentions if m.topic == "lost_module" and not places.aside(m.file)}
    yield from (_not_committed(lacking[used.name], kind) for used in unknown if used.name in lacking)
    named = {bare_name(each.name) for each in (*chosen.declared, *chosen.guessed)}  # PyFactorGraph: py_factor_graph
    unknown = [used for used in unknown if used.name not in lacking and bare_name(used.name) not in named]
    unknown = without_firmware(unknown)
    stops = {each.value: each for each in chosen.stopping}
    stopping = [used for used in unknown if used.name in stops]
    for at, found in ((stops, stopping), ({}, [used for used in unknown if used.name not in stops])):
        if found:
            first = at.get(found[0].name, found[0])
            yield warn(_of_no_table(found, at, evidence, kind, chosen), first)


def _not_committed(module: Mention, kind: Kind) -> Warning_:
    what = f"{module.file} imports {module.value}, which the tree does not have, and which is called like {module.text}"
    message = f"{what} beside it: most likely it was not committed, and what imports it stops; add it, or where it is"
    return warn(f"{message} of a package, {_asked(kind)}", module)


def _of_no_table(
    unknown: Sequence[Dependency], at: Mapping[str, Mention], evidence: Evidence, kind: Kind, chosen: Chosen
) -> str:
    """Return what is told of modules of no table; ``at``: where the default command imports them, if it does."""
    placed = [
        f"{used.name} ({(at.get(used.name) or used).file}:{(at.get(used.name) or used).line})" for used in unknown
    ]
    names = ", ".join(placed[:MOST]) if unknown[1:] else unknown[0].name
    names += ", …" if unknown[MOST:] else ""
    message = f"imported and declared nowhere, and no table knows which package brings it: {names}"
    installed = {each.url for each in chosen.guessed}
    others = [
        *(["a declared package"] if declares(chosen) else []),
        *(["a submodule"] if absent(evidence) else []),
        *(f"{git.name} ({git.url})" for git in _told(evidence) if f"git+{https(git.url)}" in installed),
        *dict.fromkeys(f"{git.name} ({https(git.url)})" for git in _may_bring(evidence, unknown[:MOST])),
        *(_of_owner(evidence, chosen, unknown) if kind in _OF_ROS else ()),
    ]
    unless = f"unless {' or '.join(others)} brings it, " if others else ""
    stops = "the default command stops at this import: " if at else ""
    needed = "" if at else " if it is needed"
    return f"{message}; {unless}{stops}{_asked(kind)}{needed}"


def _asked(kind: Kind) -> str:
    """Return where to name what brings a module."""
    source = " or its repository under `source`" if kind in _OF_ROS else ""
    return f"name the package under `pip`{source} in roslab.yaml"


def _of_owner(evidence: Evidence, chosen: Chosen, unknown: Sequence[Dependency]) -> Iterator[str]:
    """Yield in words where the build looks for modules that may be packages of the repository's owner."""
    owner = public_owner(evidence)
    able = {each.name for each in modules_of_owner(evidence, (*chosen.declared, *chosen.guessed))} if owner else set()
    if any(each.name in able for each in unknown):
        yield f"a repository of {owner} that is called like it, in which the build looks,"
    for git in linked_of_owner(evidence):
        yield f"{git.name} ({https(git.url)})"


def _tried(chosen: Chosen) -> Iterator[Warning_]:
    """Yield a warning for what is only tried: the image has another package of that name, or none."""
    stopping = {canonicalize_name(each.value) for each in chosen.stopping}
    for asked in (each for each in chosen.guessed if each.key in chosen.by_name):
        what = "the default command stops at this import" if asked.key in stopping else "what imports it stops there"
        yield warn(
            f"{asked.name} is imported and declared nowhere, and no table knows it: pip's package of that name is "
            f"tried; where it is another one, or there is none, {what}: name the right one under `pip` in roslab.yaml",
            asked,
        )


def without_history(evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for the first place where the code asks the git repository that it lies in."""
    for mention in (m for m in evidence.mentions if m.topic == "own_history"):
        why = "the code asks its own git repository, and an image has no .git: one with an empty commit is made"
        yield warn(f"{why}, so what it writes down names no commit of the source", mention)
        return


def with_told_links(evidence: Evidence, kind: Kind, chosen: Chosen) -> Chosen:
    """Add what a page at the root has people install by a link, where a module is imported that nothing else brings."""
    asked = {each.key for each in chosen.guessed}
    links = [git for git in _told(evidence) if canonicalize_name(git.name) not in asked]
    if not links or not unknown_modules(evidence, kind, chosen):
        return chosen
    found = tuple(stated(f"git+{https(git.url)}", "import", git.file, git.line) for git in links)
    return replace(chosen, guessed=(*chosen.guessed, *found))


def _told(evidence: Evidence) -> Iterator[GitSource]:
    return (git for git in evidence.sources if git.told and "/" not in git.file)


def unknown_modules(evidence: Evidence, kind: Kind, chosen: Chosen) -> list[Dependency]:
    """Return the imports of no table; where a manifest declares packages, none that begins like the name of one.

    Not those of ROS, which pip has not: they are a part for robots, without which the rest runs. What begins like the
    name of a link that a page has people install is of that. The folder of the checkout is none.
    """
    found = [used for used in _imported(evidence, kind, chosen) if canonicalize_name(used.name) not in not_on_index()]
    found = [used for used in found if used.name not in imports() and not on_index(evidence, used)]
    itself = {said.value for said in evidence.mentions if said.topic == "own_spelling"}
    itself |= of_owners(chosen) | ({each.value for each in told_ways(evidence)} if kind not in _OF_ROS else set())
    found = [used for used in found if used.name not in itself and canonicalize_name(used.name) not in itself]
    told = {bare_name(git.name) for git in _told(evidence)}
    found = [used for used in found if not _of_ros(used.name) or begins_like(used.name, told)]
    if found and (declares(chosen) or absent(evidence)):
        known = names_there(_without_left(evidence), chosen)
        stems = {part for name in known for part in name.split("-")} | {bare_name(name) for name in known}
        others = frozenset(stems - _of_itself(evidence, chosen))
        found = [each for each in found if not excuses(others, each.name) or begins_like(each.name, told)]
    return found


def _of_nodes(evidence: Evidence, kind: Kind, chosen: Chosen, ros_distro: str | None) -> Iterator[Dependency]:
    """Yield the imports of no table in packages of ROS, unless something that they name may bring one.

    Messages that nothing has are told where the workspace is decided.
    """
    if kind not in _OF_ROS:
        return
    named = {asked.name for manifest in evidence.manifests for asked in manifest.dependencies}
    named |= {asked.name for asked in evidence.prose if asked.namespace in {"apt", "ros", "rosdep"}}
    named |= {name for project in evidence.cmake for name in (*project.targets, *project.made)}
    own = {manifest.name for manifest in evidence.manifests if manifest.name}
    own |= {project.name for project in evidence.cmake if project.name}  # called after what it needs: px4_mpc
    own = {canonicalize_name(name) for name in own}
    known = names_there(evidence, chosen) | parts_of({canonicalize_name(name) for name in named} - own)
    stems = frozenset(part for part in known if len(part) >= SHORTEST)
    for used in evidence.code:
        name = canonicalize_name(used.name)
        tabled = name in not_on_index() or used.name in imports() or of_python2(used.name) or on_index(evidence, used)
        if not _always(used) or name in known | own or tabled:
            continue
        if ros_sources(used.name, 1 if kind == "ros1" else 2, ros_distro or ""):
            continue
        longer = name.startswith(tuple(own))
        if not (longer or _of_ros(used.name) or used.name.endswith(OF_MESSAGES) or excuses(stems, used.name)):
            yield used


def _of_ros(module: str) -> bool:
    return module in ros_modules() or ever_released(module)


def _of_itself(evidence: Evidence, chosen: Chosen) -> set[str]:
    """Return the names of the tree's own projects, and their parts, that nothing else has: their modules are known.

    Not of one that compiles: its modules may have any name.
    """
    own = {canonicalize_name(each.name) for each in evidence.python if each.name and not each.extensions}
    asked = (*chosen.declared, *chosen.guessed, *extras_of(evidence))
    others = {each.key for each in asked} | {canonicalize_name(git.name) for git in evidence.sources}
    others |= known_names(evidence, chosen.files, chosen.projects, chosen.conda) - own
    return parts_of(own) - parts_of(others)


def _refused(evidence: Evidence, chosen: Chosen) -> Iterator[Dependency]:
    """Yield the imports that pip's index lacks, and that nothing else brings, of packages of ROS too.

    What a page only clones is not installed by that, and neither is what a guess names and pip lacks.
    """
    used = [each for each in evidence.code if canonicalize_name(each.name) in not_on_index()]
    if used := [each for each in used if _always(each)]:
        there = tuple(each for each in chosen.guessed if not ((row := refused(each)) and not row.instead))
        known = names_there(_without_left(evidence), replace(chosen, guessed=there))
        yield from (each for each in used if canonicalize_name(each.name) not in known)


def _always(used: Dependency) -> bool:
    """Tell whether it is a module that the program itself always imports."""
    return used.namespace == "import" and used.strength == "used" and not places.aside(used.file)


def _imported(evidence: Evidence, kind: Kind, chosen: Chosen) -> Iterator[Dependency]:
    """Yield what the code always imports and nothing brings under its own name."""
    known = names_there(_without_left(evidence), chosen) if kind in {"cuda", "python"} else set()
    for used in evidence.code if kind in {"cuda", "python"} else ():
        if _always(used) and canonicalize_name(used.name) not in known:
            yield used


def _without_left(evidence: Evidence) -> Evidence:
    """Return the evidence without what pages only clone, which no image does for a module.

    What is compiled and installed by hand may be built.
    """
    return replace(evidence, sources=tuple(git for git in evidence.sources if not _only_cloned(git)))


def _may_bring(evidence: Evidence, unknown: Sequence[Dependency]) -> Iterator[GitSource]:
    """Yield what pages only clone and the beginning of whose name one of the modules has."""
    for git in evidence.sources:
        name = {bare_name(part) for part in (git.name, canonicalize_name(git.name).split("-")[0])}
        if _only_cloned(git) and not git.itself and any(begins_like(each.name, name) for each in unknown):
            yield git


def _only_cloned(git: GitSource) -> bool:
    return git.kind == "clone" and not (git.installed or git.beside)
