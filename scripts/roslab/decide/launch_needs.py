"""What the launch file of the default command needs and nothing gives it: variables, packages, interpreters."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.config.model import Config
from roslab.decide.author_folders import absent_paths
from roslab.decide.command import Command
from roslab.decide.cuda.on_gpu import computing_there
from roslab.decide.decision import Choice, Warning_
from roslab.decide.executed_programs import executed_programs
from roslab.decide.launch_calls import started_launch
from roslab.decide.reasons import warn
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.sought import tried
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import packages_of
from roslab.decide.startable_launches import lacks
from roslab.decide.unmade_nodes import unmade_nodes
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile
from roslab.knowledge.distros import distros
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import ros_modules
from roslab.knowledge.hook_variables import set_by_hooks
from roslab.knowledge.machine_variables import of_every_image
from roslab.knowledge.released import released
from roslab.values.dataclass import replace

MOST = 8
"""Most packages that are named in one warning."""


def decide_launch_needs(
    evidence: Evidence,
    config: Config,
    command: Command,
    *,
    there: Iterable[tuple[str, str]],
    sources: Sources,
    ros_distro: str | None,
    linked: Iterable[tuple[str, str]],
    folders: Iterable[tuple[str, str]],
    left_out: Collection[str],
) -> Choice[None]:
    """Return a warning for each variable, package, interpreter and launch file without which the default command stops.

    ``there``: the variables that it has, ``sources``: what is cloned, ``linked`` and ``folders``: the interpreters and
    the folders of the author's that links stand for, ``left_out``: the packages of the tree that are not built.
    For its packages and interpreters, what it starts is read too. One more for the packages of its other launch files.
    """
    if config.compatible:
        return Choice(answer=None)
    launch = started_launch(evidence, command.command)
    others = tuple(_of_others(evidence, launch, sources, ros_distro)) if ros_distro else ()
    absent = tuple(absent_paths(evidence, command.command, launch, folders, linked))
    if launch is None:
        return Choice(answer=None, warnings=(*absent, *others))
    from roslab.decide.launched_simulators import lacking_simulators  # noqa: PLC0415 - few default commands launch
    from roslab.decide.launched_vendors import lacking_vendors  # noqa: PLC0415 - as above

    given = {name for name, _ in (*there, *config.env)} | set_by_hooks(_named(evidence, launch))
    told = [
        Warning_(
            message=f"the default command needs the variable {name}, which nothing sets, and stops without it: set it "
            "under `env` in roslab.yaml",
            file=launch.file,
            line=line,
        )
        for name, line in launch.variables
        if name not in given and not of_every_image(name)
    ]
    told += _packages(evidence, launch, sources, ros_distro)
    told += _not_built(launch, left_out)
    told += [
        Warning_(
            message=f"the default command starts {file}, whose first line names {named}, which the image does not "
            "have: it cannot be started; write `#!/usr/bin/env python`, or `python3`, there",
            file=file,
            line=1,
        )
        for file, named in launch.foreign
        if named not in dict(linked)
    ]
    told += [
        Warning_(
            message=f"the default command includes {name} of the package {package}, which has no such file, and stops "
            "there: add it, or set `command` in roslab.yaml",
            file=file,
            line=line,
        )
        for package, name, file, line in launch.gone
    ]
    told += [
        Warning_(
            message=f"the default command loads {path}, in which the reader is to put a path of his own, and stops "
            "there: write that of a file of the tree, or set `command` in roslab.yaml",
            file=launch.file,
            line=line,
        )
        for path, line in launch.to_fill[:1]
    ]
    told += _of_windows(evidence, launch, sources, ros_distro)
    told += _elsewhere(evidence, launch, ros_distro)
    told += absent
    told += unmade_nodes(evidence, launch)
    told += executed_programs(evidence, launch)
    if at := computing_there(evidence, command.command) if config.gpu is None else None:
        why = f"what the default command starts computes on a GPU in any case ({at.text})"
        told.append(
            warn(f"{why}: it needs a machine with one of NVIDIA; `gpu: false` in roslab.yaml gives it none", at)
        )
    told += lacking_simulators(evidence, config, launch, given, ros_distro)
    told += lacking_vendors(evidence, config, launch, ros_distro)
    return Choice(answer=None, warnings=(*told, *others))


def _elsewhere(evidence: Evidence, launch: LaunchFile, ros_distro: str | None) -> Iterator[Warning_]:
    """Yield a warning for each program that imports what nothing brings from a folder of the author's machine."""
    brought = imports().keys() | ros_modules() | released(ros_distro or "") | _named_packages(evidence)
    unknown: dict[str, list[str]] = {}
    for each in evidence.code:
        if each.namespace == "import" and each.strength == "used" and each.name not in brought:
            unknown.setdefault(each.file, []).append(each.name)
    for file, folder, line in launch.elsewhere:
        if names := unknown.pop(file, []):
            message = f"the default command starts {file}, which imports {', '.join(names)} and looks in {folder}, a "
            hint = "give what is in it under `source` or `custom` in roslab.yaml, or set `command`"
            told = f"{message}folder of the author's machine: where nothing else brings that, it stops; {hint}"
            yield Warning_(message=told, file=file, line=line)


def _named_packages(evidence: Evidence) -> set[str]:
    names = {m.name for m in evidence.manifests if m.name}
    return names | {d.name for m in evidence.manifests for d in m.dependencies}


def _named(evidence: Evidence, launch: LaunchFile) -> Iterator[str]:
    """Yield the packages that a launch file, what it starts, and the packages of the tree ask for."""
    yield from (asked.name for asked in (*launch.dependencies, *launch.reached) if asked.namespace == "ros")
    for manifest in packages_of(evidence).built:
        yield from (asked.name for asked in manifest.dependencies)


def packages_lacking(
    evidence: Evidence, config: Config, command: tuple[str, ...] | str, ros_distro: str | None
) -> tuple[Dependency, ...]:
    """Return the packages that the launch file of the default command needs and the repository does not have."""
    launch = None if isinstance(command, str) or config.compatible else started_launch(evidence, command)
    found = lacks(evidence, lambda _: False, ros_distro).get(launch.file, ()) if launch else ()
    return tuple(replace(asked, strength="declared") for asked in found)


def lacking_elsewhere(
    evidence: Evidence, launch: LaunchFile | None, sources: Sources, ros_distro: str
) -> dict[str, Dependency]:
    """Return what launch files other than the default command's need, and that no clone may bring, by its name."""
    names = sources.names | {plain(source.name) for source in sources.submodules}
    found = lacks(evidence, lambda name: bool(names & {name, plain(name)}) or sources.may_hold(name), ros_distro)
    told = {asked.name for asked in found.get(launch.file, ())} if launch else set()
    needed: dict[str, Dependency] = {}
    built = {manifest.name for manifest in packages_of(evidence).built}
    generation = distros()[ros_distro].ros
    meant = {each.file for each in evidence.launch if each.ros == generation and each.package in built}
    for file, lacking in found.items():
        for asked in lacking if file in meant and not places.aside(file) else ():
            if asked.name not in told:
                needed.setdefault(asked.name, asked)
    return needed


def _of_others(evidence: Evidence, launch: LaunchFile | None, sources: Sources, ros_distro: str) -> Iterator[Warning_]:
    """Yield a warning for what other launch files need, one for what nothing looks for and one for the rest."""
    where = tried(sources.sought)
    needed = lacking_elsewhere(evidence, launch, sources, ros_distro)
    if renamed := {name: there for name in needed if (there := sources.renamed(name))}:
        message = "launch files name packages otherwise than the cloned repositories that have them, and stop"
        said = _listed(f"{there} for {name}" for name, there in renamed.items())
        yield warn(f"{message}: write {said}", needed[next(iter(renamed))])
    needed = {name: asked for name, asked in needed.items() if name not in renamed}
    here = "give their repositories under `source` in roslab.yaml"
    if unknown := [asked for name, asked in needed.items() if name not in where]:
        message = "launch files need packages that nothing is known to bring, and stop without them"
        yield warn(f"{message}: {_listed(each.name for each in unknown)}; {here}", unknown[0])
    if looked := [asked for name, asked in needed.items() if name in where]:
        message = "launch files need packages that nothing is known to bring; the build looks for"
        said = _listed(f"{each.name} in {where[each.name]}" for each in looked)
        yield warn(f"{message} {said}; where one is not there, they stop: {here}", looked[0])


def _listed(names: Iterable[str]) -> str:
    names = [*names]
    return ", ".join(names[:MOST]) + (", …" if len(names) > MOST else "")


def _not_built(launch: LaunchFile, left_out: Collection[str]) -> Iterator[Warning_]:
    """Yield a warning for each package of the tree that a launch file needs and that is left out of the build."""
    told: set[str] = set()
    for asked in (*launch.dependencies, *launch.reached):
        if asked.namespace == "ros" and asked.strength != "optional" and asked.name in {*left_out} - told:
            told.add(asked.name)
            then = "it stops there" if launch.ros == 2 else "at most a part of it runs"
            message = f"the default command needs {asked.name}, which is left out of the build: {then}"
            yield warn(f"{message}; give what the package lacks, or set `command` in roslab.yaml", asked)


def _of_windows(evidence: Evidence, launch: LaunchFile, sources: Sources, ros_distro: str | None) -> Iterator[Warning_]:
    """Yield a warning for the packages of plugins that rviz is to load and that nothing is known to bring."""
    there = packages_of(evidence).names | released(ros_distro or "") | sources.names
    plugins = {d.name: d for d in reversed(launch.reached) if d.file.endswith(".rviz") and d.name not in there}
    if lost := [plugins[name] for name in sorted(plugins) if not sources.may_hold(name)]:
        message = f"rviz is to load plugins of {_listed(each.name for each in lost)}, which nothing is known to bring"
        hint = "give their repositories under `source` in roslab.yaml"
        yield warn(f"{message}: it shows errors in their places; {hint}", lost[0])


def _packages(evidence: Evidence, launch: LaunchFile, sources: Sources, ros_distro: str | None) -> Iterator[Warning_]:
    """Yield a warning for each package that a launch file needs, and that no clone is called like or known to hold.

    A key of a package.xml that no distribution has is one of them: without it the packages are built all the same.
    """
    where = tried(sources.sought)
    names = sources.names | {plain(source.name) for source in sources.submodules}
    for asked in lacks(evidence, lambda name: bool(names & {name, plain(name)}), ros_distro, asked=False).get(
        launch.file, ()
    ):
        looked = ""
        if asked.name in where:
            looked = f"the build looks for it in {where[asked.name]}; where it is not there, "
        elif sources.may_hold(asked.name):
            looked = "one of the cloned repositories may hold it; else "
        what = f"the default command needs the package {asked.name}, which nothing is known to bring, and stops without"
        yield warn(f"{what} it: {looked}give its repository under `source` in roslab.yaml", asked)
