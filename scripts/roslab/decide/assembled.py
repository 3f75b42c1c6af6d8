"""From the choices of all questions to one decision."""

from __future__ import annotations

from roslab.config.model import BuildTool, Config, Kind
from roslab.decide.absent_launches import decide_absent_launches
from roslab.decide.author_dockerfile import Dockerfile
from roslab.decide.author_folders import decide_author_folders
from roslab.decide.base import BaseImage
from roslab.decide.command import Command
from roslab.decide.conflicts import decide_conflicts
from roslab.decide.cuda.on_gpu import needs_gpu, told_of_no_gpu
from roslab.decide.cuda.version import Cuda
from roslab.decide.decision import Choice, Decision, Download, MendedBase, OwnScript
from roslab.decide.foreign_interpreters import decide_interpreters
from roslab.decide.goes_without import goes_without
from roslab.decide.head_archives import head_archives
from roslab.decide.launch_needs import decide_launch_needs
from roslab.decide.launched_simulators import brought_simulators
from roslab.decide.nodes_without_ros import decide_nodes
from roslab.decide.old_compiler import decide_compiler
from roslab.decide.opened import decide_opened
from roslab.decide.outside import decide_outside
from roslab.decide.platforms import Platforms
from roslab.decide.processor import compiles_for_here, problems, stops_at_warnings
from roslab.decide.proof import compiled, rostests, runs_ctest
from roslab.decide.python.at_top import imported_by_command
from roslab.decide.python.compiling import Compiling
from roslab.decide.python.image_python import Python
from roslab.decide.python.paths import python_path
from roslab.decide.python_in_scripts import decide_python_in_scripts
from roslab.decide.reasons import warn
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.hidden_packages import decide_hidden
from roslab.decide.ros.in_bin import in_bin
from roslab.decide.ros.in_tree import apart
from roslab.decide.ros.included_interfaces import included_interfaces
from roslab.decide.ros.keys import by_pip
from roslab.decide.ros.layout import Layout
from roslab.decide.ros.linked_install import by_links, omitted
from roslab.decide.ros.named import by_pages
from roslab.decide.ros.not_there import decide_not_there
from roslab.decide.ros.submodule_packages import may_fail_in
from roslab.decide.ros.wanted import wanted_beside
from roslab.decide.ros.workspace import Packages, manifests_of, names_of
from roslab.decide.stops_without import decide_stops
from roslab.decide.system.header_definitions import header_definitions_of
from roslab.decide.system.inside import installed_inside
from roslab.decide.system.linked_headers import linked_headers
from roslab.decide.system.missing import Missing, marked
from roslab.decide.system.names import Target
from roslab.decide.system.needs import host_options
from roslab.decide.system.own_options import options_of_program, own_compilers, own_options, where_built
from roslab.decide.system.own_packages import own_packages
from roslab.decide.system.packages import SystemPackages
from roslab.decide.system.spare import most
from roslab.decide.uncopied_packages import copied_names
from roslab.decide.unknown_packages import decide_unknown_packages
from roslab.evidence.facts import Evidence
from roslab.evidence.roles import GIT_LFS
from roslab.knowledge.distros import Distro
from roslab.values.dataclass import dataclass, replace
from roslab.values.requirement import Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class Choices:
    """What was chosen for each question, in the order in which it is told."""

    day: Choice[str | None]
    pip_day: Choice[str | None]
    kind: Choice[Kind]
    release: Choice[Distro | None]
    base: Choice[BaseImage]
    build_tool: Choice[BuildTool]
    layout: Choice[Layout]
    python: Choice[Python]
    cuda: Choice[Cuda]
    own: Choice[Dockerfile | None]
    mended: Choice[tuple[MendedBase, ...]]
    command: Choice[Command]
    test: Choice[tuple[str, ...] | str | None]
    platforms: Choice[Platforms]
    sources: Choice[Sources]
    system: Choice[SystemPackages]
    inside: Choice[tuple[tuple[str, str], ...]]
    repositories: Choice[tuple[str, ...]]
    scripts: Choice[tuple[OwnScript, ...]]
    missing: Choice[Missing]
    steps: Choice[None]
    variables: Choice[tuple[tuple[str, str], ...]]
    downloads: Choice[tuple[Download, ...]]
    packages: Packages
    target: Target
    everything: tuple[Requirement, ...]
    compiling: Compiling
    clones_day: Choice[str]
    dockerfile: str | None
    on_cuda: bool
    left_out: tuple[str, ...]


def _by_apt(of: Choices) -> tuple[str, ...]:
    return (*of.system.answer.apt, *of.system.answer.apt_guessed)


def decision_of(of: Choices, evidence: Evidence, config: Config, *, folder_name: str) -> Decision:
    """Return the decision with all reasons and warnings; none of what the author's Dockerfile does in its own way."""
    distro, ubuntu = of.release.answer.name if of.release.answer else None, of.base.answer.ubuntu
    ros, tool = of.kind.answer in {"ros1", "ros2"}, of.build_tool.answer
    linked = by_links(evidence, config, tool)
    not_there = decide_not_there(evidence, config, of.packages, of.left_out, tool)
    interpreters = decide_interpreters(evidence, config, ubuntu)
    files: Choice[tuple[str, ...]] = Choice(answer=())
    if not of.own.answer:
        simulators = brought_simulators(evidence, config, of.command.answer.command, distro)
        files = own_packages(evidence, config, ubuntu, simulators, of.platforms.answer.built)
    folders = decide_author_folders(evidence, config, of.packages, of.layout.answer, tool, image=of.base.answer.image)
    without = goes_without(of, evidence, config)
    hidden = decide_hidden(evidence, config, of.packages, tool, command=of.command.answer.command, left_out=of.left_out)
    compiler = decide_compiler(of, evidence, config)
    choices = (
        of.day,
        *(() if of.pip_day.answer and (of.own.answer or not of.python.answer.day) else (of.pip_day,)),
        *(
            of.kind,
            of.release,
            of.base,
            of.build_tool,
            of.layout,
            replace(of.python, warnings=()) if of.own.answer else of.python,
            of.cuda,
            of.own,
            of.mended,
            of.command,
            of.test,
            of.platforms,
        ),
        of.sources,
        *((replace(choice, warnings=()) if of.own.answer else choice) for choice in (without.system, of.inside)),
        *(
            ()
            if of.own.answer
            else (
                *(of.repositories, of.scripts, without.missing, not_there, hidden),
                *(of.steps, of.variables, of.downloads, of.clones_day),
            )
        ),
        *(
            ()
            if of.own.answer
            else (
                decide_launch_needs(
                    evidence,
                    config,
                    of.command.answer,
                    there=of.variables.answer,
                    sources=of.sources.answer,
                    ros_distro=distro,
                    linked=interpreters.answer,
                    folders=folders.answer,
                    left_out=of.left_out,
                ),
                *(interpreters, folders),
            )
        ),
        decide_conflicts(evidence),
        decide_absent_launches(evidence, of.kind.answer),
        *(
            ()
            if of.own.answer
            else (
                decide_opened(evidence, config, of.command.answer.command, of.downloads.answer),
                decide_outside(evidence, config, of.kind.answer),
                decide_unknown_packages(
                    evidence, config, of.kind.answer, of.sources.answer, (*_by_apt(of), *config.apt)
                ),
                decide_nodes(evidence, config, of.kind.answer, of.base.answer, of.python.answer),
                decide_python_in_scripts(evidence, config, of.kind.answer, of.base.answer.image, of.python.answer),
            )
        ),
        *(() if of.own.answer else (decide_stops(evidence, config, of.base.answer.image),)),
        *(files, compiler),
    )
    return Decision(
        kind=of.kind.answer,
        ros_distro=distro,
        ubuntu=of.base.answer.ubuntu,
        base_image=of.base.answer.image,
        build_tool=tool,
        rosdep=of.system.answer.rosdep,
        rosdep_pip=by_pip(of.system.answer.rosdep),
        skip_keys=of.system.answer.skip_keys,
        repositories=() if of.own.answer else (*of.repositories.answer, *compiler.answer.repositories),
        apt=(*of.system.answer.apt, *compiler.answer.apt),
        apt_guessed=tuple(name for name in of.system.answer.apt_guessed if name not in compiler.answer.apt),
        python=of.python.answer,
        pip=of.everything,
        compiling=of.compiling,
        source=(*of.sources.answer.sources, *of.sources.answer.sought),
        vcs=of.sources.answer.vcs,
        submodules=() if of.own.answer else of.sources.answer.submodules,
        apart=() if of.own.answer or config.compatible else apart(evidence, of.packages),
        may_fail=() if without.whole else (*may_fail_in(evidence, of.packages, without.failing), *without.plain),
        spare=without.alone,
        most_spare=most(without.alone),
        interfaces=() if without.whole else included_interfaces(evidence, of.packages, distro),
        wanted=wanted_beside(of.sources.answer, of.packages, of.missing.answer.unsure),
        must_build=without.needed,
        large_files=GIT_LFS in _by_apt(of) and not config.compatible,
        inside=of.inside.answer,
        inside_installed=() if of.own.answer else installed_inside(evidence, of.inside.answer),
        python_path=python_path(evidence, config, of.kind.answer, of.python.answer, of.command.answer),
        variables=() if of.own.answer else (*of.variables.answer, *compiler.answer.variables),
        scripts=() if of.own.answer else of.scripts.answer,
        downloads=() if of.own.answer else of.downloads.answer,
        packages=manifests_of(of.packages, of.left_out) if ros else (),
        package_names=copied_names(names_of(of.packages, of.kind.answer, of.left_out, tool), of.dockerfile, evidence),
        by_pages=by_pages(
            evidence,
            config,
            tool,
            packages=of.packages,
            left_out=of.left_out,
            sources=of.sources.answer.sources,
            ros_distro=distro,
            needed=without.needed,
        ),
        left_out=of.left_out,
        ignored=()
        if of.own.answer
        else (*hidden.answer.above, *marked(tool, of.missing.answer, of.packages, evidence)),
        hidden=() if of.own.answer else hidden.answer.folders,
        ended=of.missing.answer.ended,
        not_there=() if of.own.answer else not_there.answer,
        lacking=() if of.own.answer else of.missing.answer.lacking,
        undeclared=of.missing.answer.undeclared,
        copied_scripts=tuple(m.value for m in evidence.mentions if m.topic == "copied_script"),
        in_bin=in_bin(evidence),
        by_links=linked,
        workspace=of.layout.answer.workspace,
        set_up_links=of.layout.answer.set_up_links,
        git_folder=not config.compatible and any(m.topic in {"git_folder", "own_history"} for m in evidence.mentions),
        cmake_folder=of.layout.answer.cmake_folder,
        program_folders=of.layout.answer.program_folders,
        installed=of.layout.answer.installed,
        cmake_options=(
            *where_built(own_options(evidence, config, folder_name, tool), of.sources.answer.sources),
            *of.missing.answer.options,
            *options_of_program(evidence, config, tool, of.command.answer.command, cuda=of.on_cuda),
            *header_definitions_of(evidence, config, tool),
        ),
        cuda_options=host_options(of.system.answer.installed, of.base.answer.ubuntu),
        own_packages=files.answer,
        header_links=linked_headers(evidence, of.base.answer.ubuntu),
        cmake_modules=tuple(m.value for m in evidence.mentions if m.topic == "module_aside"),
        interpreters=() if of.own.answer else interpreters.answer,
        author_folders=() if of.own.answer else folders.answer,
        native=compiles_for_here(evidence) and not config.compatible,
        compiled_files=evidence.compiled_files,
        strict=stops_at_warnings(evidence) and not config.compatible,
        compilers=own_compilers(evidence, config, folder_name) if tool == "cmake" else (),
        dockerfile=of.dockerfile,
        context=of.own.answer.context if of.own.answer else None,
        bases=of.mended.answer,
        day=of.day.answer,
        command=of.command.answer.command,
        command_given=of.command.answer.given,
        command_imports=imported_by_command(evidence, of.command.answer, of.python.answer.pip_guessed),
        command_through_entrypoint=of.command.answer.entrypoint,
        entrypoint_takes=of.command.answer.entrypoint_takes,
        command_named=config.command is not None,
        command_candidates=of.command.answer.candidates,
        test=of.test.answer,
        rostests=() if of.own.answer else rostests(evidence, of.kind.answer, tool),
        tests=() if of.own.answer else evidence.tests,
        ctest=runs_ctest(evidence, config, folder_name, tool, of.missing.answer.tests),
        compiles=bool(compiled(evidence)),
        clones_day=of.clones_day.answer,
        downloads_heads=bool(head_archives(evidence)),
        without=of.platforms.answer.without,
        platforms=of.platforms.answer.built,
        platforms_refused=of.platforms.answer.refused,
        cuda=of.cuda.answer.version,
        cudnn=of.cuda.answer.cudnn,
        gpu=needs_gpu(evidence, config, of.command.answer.command, of.system.answer.installed, cuda=of.on_cuda),
        gui=of.command.answer.gui,
        ports=of.command.answer.ports,
        volumes=of.command.answer.volumes,
        warnings=(
            *problems(evidence, of.dockerfile, tool, of.python.answer.projects),
            *(() if linked else omitted(evidence)),
            *(warn(message, origin) for message, origin in config.warnings),
            *(warning for choice in choices for warning in choice.warnings),
            *(() if of.on_cuda or of.own.answer or config.gpu is not None else told_of_no_gpu(evidence, of.everything)),
        ),
        reasons=tuple(reason for choice in choices for reason in choice.reasons),
    )
