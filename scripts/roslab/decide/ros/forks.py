"""Forks of released packages that a page lists among what is needed: these are compiled, and not taken from apt."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.config.model import BuildTool, Config, Source, workspace_tool
from roslab.decide.decision import Choice, Warning_
from roslab.decide.reasons import because, warn
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.sought import folder_for
from roslab.decide.ros.source_names import SHORTEST, address, day_of_clone, fixed, plain
from roslab.decide.ros.weights import Weight
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.said_of_links import unchanged
from roslab.evidence.ros.vcs import https
from roslab.knowledge.listed_repositories import listed_repository
from roslab.knowledge.released import released
from roslab.values.dataclass import replace
from roslab.values.origin import Place

_NOT_BUILT = frozenset({"test", "doc", "exec", "run"})


def with_forks(
    choice: Choice[Sources], evidence: Evidence, config: Config, *, ros_distro: str | None, build_tool: BuildTool
) -> Choice[Sources]:
    """Return the sources with the forks of which a package.xml or CMake needs packages that the distribution released.

    Only these packages are compiled of one, as of the repository's day; where it is not there, apt's are installed, as
    where a page has another repository of the repository's owner than the distribution and does not say why: that is
    told. Not for the old formats, whose images never had them.
    """
    build = workspace_tool(build_tool)
    if build is None or config.compatible:
        return choice
    sources = choice.answer
    taken = {address(source.repo or "") for source in (*sources.sources, *sources.submodules)}
    taken.add(address(evidence.origin or ""))
    sought = {address(source.repo or ""): source for source in sources.sought}
    day = date.value if (date := dated(evidence)) else ""
    forks: list[Source] = []
    reasons = []
    warnings = list(choice.warnings)
    for git, asked in _listed(evidence, ros_distro or ""):
        names = tuple(each.name for each in asked)
        if address(git.url) in taken or sources.names.intersection(names):
            continue
        if not git.forked:
            if other := _of_another(git, evidence):
                warnings.append(_told(git, asked, other))
            continue
        ref = fixed(git.ref)
        looked_in = sought.pop(address(git.url), None)
        source = looked_in or Source(
            name=folder_for(git.url, [*sources.sources, *sources.sought, *forks]),
            repo=https(git.url),
            ref=ref,
            build=build,
            before=day_of_clone(ref, day),
            place=Place(file=git.file, line=git.line),
        )
        forks.append(replace(source, holding=(*names, *source.holding)))
        why = f"{asked[0].file}:{asked[0].line} needs {', '.join(names)}, of which {git.file} lists a fork"
        reasons.append(because("source", source.name, why, git, weight=Weight.LISTED))
    answer = replace(sources, sought=(*forks, *sought.values())) if forks else sources
    return replace(choice, answer=answer, reasons=(*choice.reasons, *reasons), warnings=tuple(warnings))


def _listed(evidence: Evidence, ros_distro: str) -> Iterator[tuple[GitSource, list[Dependency]]]:
    """Yield what pages list as needed or have the reader install, each with the released packages of such names."""
    there, own = released(ros_distro), {manifest.name for manifest in evidence.manifests}
    needed: dict[str, Dependency] = {}
    declared = [each for m in evidence.manifests for each in m.dependencies if each.role not in _NOT_BUILT]
    required = (each for p in evidence.cmake if not places.aside(p.file) for each in p.dependencies if each.required)
    for each in (*declared, *(d for d in required if not d.condition)):
        if each.name in there and each.name not in own:
            needed.setdefault(each.name, each)
    for git in evidence.sources:
        if git.kind == "link" and (git.holds or git.told) and not git.private:
            names = {plain(_forked_from(git.name, there)), plain(git.fork_of) if len(git.fork_of) >= SHORTEST else ""}
            found = [each for each in needed.values() if _of_family(each.name, names)]
            if found:
                more = [each for each in _started(evidence) if _of_family(each.name, names)] if git.forked else []
                yield git, list({each.name: each for each in (*found, *more)}.values())


def _started(evidence: Evidence) -> Iterator[Dependency]:
    """Yield the packages of ROS that launch files and nodes start something of, or find."""
    launched = (each for launch in evidence.launch for each in launch.dependencies)
    yield from (each for each in (*launched, *evidence.code) if each.namespace == "ros" and each.role == "exec")


def _of_family(package: str, names: Iterable[str]) -> bool:
    """Tell whether a package is called like one of some names, or begins with it: ``nav2_core`` is of ``nav2``."""
    return any(name and f"{plain(package)}_".startswith(f"{name}_") for name in names)


def _forked_from(name: str, packages: AbstractSet[str]) -> str:
    """Return what a repository is a fork of by its name, if ROS has that: ``custom_controller`` is of none."""
    called = unchanged(name)
    return called if plain(called) in packages or listed_repository(called) else name


def _of_another(git: GitSource, evidence: Evidence) -> str:
    """Return the address of the repository that ROS lists by a name, where that is another than the owner's."""
    owner = address(evidence.origin or "").rpartition("/")[0]
    other = listed_repository(git.name)
    mine = address(git.url).rpartition("/")[0] == owner
    return other if owner and mine and other and address(other) != address(git.url) else ""


def _told(git: GitSource, asked: list[Dependency], other: str) -> Warning_:
    names = ", ".join(each.name for each in asked)
    message = f"{git.url} is listed among what is needed, and {names} of ROS, from {other.removesuffix('.git')}, is"
    more = "installed: where its owner's repository differs from that, give it under source in roslab.yaml"
    return warn(f"{message} {more}", git)
