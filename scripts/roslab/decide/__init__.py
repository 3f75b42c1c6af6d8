"""Evidence, configuration and knowledge → one decision per question, each with its reasons."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.author_dockerfile import decide_dockerfile
from roslab.decide.authored import as_authored
from roslab.decide.base import decide_base
from roslab.decide.build_tool import decide_build_tool
from roslab.decide.chains import decide_bases
from roslab.decide.command import decide_command
from roslab.decide.cuda.for_ubuntu import with_an_image_for
from roslab.decide.cuda.toolkit import by_script, decide_toolkit
from roslab.decide.cuda.version import NO_CUDA, decide_cuda
from roslab.decide.day import decide_days
from roslab.decide.decision import Decision, Warning_
from roslab.decide.downloads import decide_downloads
from roslab.decide.kind import decide_kind
from roslab.decide.launch_needs import decide_launch_needs
from roslab.decide.nothing import require_something
from roslab.decide.old_formats import as_it_was, narrowed
from roslab.decide.outside import decide_outside
from roslab.decide.platforms import decide_platforms
from roslab.decide.processor import decide_processor
from roslab.decide.proof import compiled, decide_test, rostests, runs_ctest
from roslab.decide.python.alternatives import one_way
from roslab.decide.python.brought import with_what_is_brought
from roslab.decide.python.compiling import decide_compiling
from roslab.decide.python.environment import decide_python
from roslab.decide.python.installed import installed
from roslab.decide.python.own import decide_version
from roslab.decide.python.paths import python_path
from roslab.decide.python.pins import pins
from roslab.decide.reasons import warn
from roslab.decide.ros.distro import decide_distro
from roslab.decide.ros.filled_refs import with_refs
from roslab.decide.ros.in_tree import apart
from roslab.decide.ros.itself import names_of_itself
from roslab.decide.ros.layout import decide_layout
from roslab.decide.ros.named import by_pages
from roslab.decide.ros.sought import linked, tried, without
from roslab.decide.ros.sources import decide_sources, with_recipes
from roslab.decide.ros.used import asked
from roslab.decide.ros.workspace import manifests_of, names_of, of_one_ros, packages_of
from roslab.decide.steps import decide_steps
from roslab.decide.system.apt_sources import decide_apt_sources
from roslab.decide.system.gazebo import with_release
from roslab.decide.system.guards import required_by_command
from roslab.decide.system.inside import compiled_inside
from roslab.decide.system.libraries import decide_libraries
from roslab.decide.system.linked_headers import linked_headers
from roslab.decide.system.missing import decide_missing, marked, provided
from roslab.decide.system.names import Target
from roslab.decide.system.needs import host_options
from roslab.decide.system.own_options import options_of_program, own_compilers, own_options
from roslab.decide.system.own_scripts import decide_scripts
from roslab.decide.system.packages import decide_system, with_libraries
from roslab.decide.variables import decide_variables
from roslab.evidence.facts import Evidence
from roslab.evidence.native.cpu import told

_ROS: frozenset[Kind] = frozenset({"ros1", "ros2"})


def decide(evidence: Evidence, config: Config, *, folder_name: str) -> Decision:
    """Answer every question about a repository; ``folder_name`` is its name if nothing else gives one.

    roslab.yaml and the action's inputs, already one ``Config``, win over the evidence, which wins over defaults.
    Raises ``NothingToBuildError`` where there is nothing to decide on.
    """
    require_something(evidence, config, folder_name)
    evidence, config = narrowed(evidence, config)
    day, pip_day, evidence = decide_days(evidence, config)
    kind = decide_kind(evidence, config, folder_name)
    evidence = with_what_is_brought(evidence, kind.answer, folder_name)
    release = decide_distro(evidence, config, kind.answer)
    distro = release.answer.name if release.answer else None
    cuda = decide_cuda(evidence, config, pins(evidence))
    evidence = with_refs(one_way(evidence, cuda.answer.version), distro)
    mentioned = pins(evidence)
    version = decide_version(evidence, config, kind.answer, pins=mentioned, ros_distro=distro, cuda=cuda.answer.version)
    cuda = with_an_image_for(cuda, evidence, config, kind.answer, version.answer.version)
    base = decide_base(
        evidence,
        config,
        kind.answer,
        chosen=release,
        cuda=cuda.answer,
        python=version.answer.version,
        toolkit=decide_toolkit(evidence, version.answer.chosen),
    )
    python = decide_python(
        evidence,
        config,
        kind.answer,
        pins=mentioned,
        own=version,
        ubuntu=base.answer.ubuntu,
        ros_distro=distro,
        cuda=cuda.answer.version,
    )
    everything = installed(evidence, python.answer)
    own = decide_dockerfile(evidence, config, kind.answer, distro)
    dockerfile = own.answer.file if own.answer else None
    mended = decide_bases(evidence, config, dockerfile)
    base, cuda, python = as_authored(dockerfile, evidence, config, mended.answer, base=base, cuda=cuda, python=python)
    command = decide_command(evidence, config, kind.answer, dockerfile, python.answer.version)
    evidence = required_by_command(evidence, command.answer.command)
    build_tool = decide_build_tool(evidence, config, kind.answer, python.answer)

    packages = of_one_ros(packages_of(evidence), evidence, kind.answer)
    layout = decide_layout(evidence, kind.answer, packages)
    target = Target(
        ros_distro=distro,
        ubuntu=base.answer.ubuntu,
        cuda="cuda" in base.answer.image,
        modules=evidence.cmake_modules,
        unfound=evidence.by_variables,
    )
    sources = decide_sources(
        evidence,
        config,
        kind.answer,
        ros_distro=distro,
        build_tool=build_tool.answer,
        needed=asked(evidence, packages, target, kind.answer),
        own=packages.names,
        folder_name=folder_name,
    )
    system = decide_system(
        evidence,
        config,
        kind.answer,
        target=target,
        packages=packages,
        python=python.answer,
        installed=everything,
        base_packages=base.answer.ros_packages,
        sisters=sources.answer.names,
        may_hold=sources.answer.may_hold,
        tried=tried(sources.answer.sought),
    )
    python, system, sources, layout = as_it_was(
        config, base_packages=base.answer.ros_packages, python=python, system=system, sources=sources, layout=layout
    )
    if config.compatible:
        everything = installed(evidence, python.answer)
    libraries = decide_libraries(
        evidence,
        config,
        kind.answer,
        target=target,
        packages=packages,
        sources=sources.answer,
        system=system.answer,
        folder_name=folder_name,
        cuda=cuda.answer.version if target.cuda else None,
    )
    sources = with_recipes(sources, libraries)
    system = with_release(with_libraries(system, frozenset(s.name for s, _ in libraries)), evidence, target)

    repositories = decide_apt_sources(
        evidence, config, frozenset((*system.answer.apt, *system.answer.apt_guessed)), base.answer.ubuntu
    )
    inside = compiled_inside(evidence, config, kind.answer)
    scripts = decide_scripts(evidence, config, kind.answer, inside, python.answer.projects, target=target)
    projects = [project for project in evidence.python if (project.folder or ".") in python.answer.projects]
    variables = decide_variables(
        evidence,
        config,
        base.answer.ubuntu,
        (*everything, *(each for project in projects for each in project.build_requires)),
        command=command.answer.page,
        image=base.answer.image,
    )
    downloads = decide_downloads(evidence, config, command.answer.command, folder_name, command.answer.page)
    on_cuda = "nvidia" in base.answer.image or kind.answer == "cuda" or bool(config.base.cuda)
    cuda = cuda if on_cuda else NO_CUDA
    compiling = decide_compiling(
        projects, (*everything, *python.answer.first), cuda.answer.version, evidence.unsafe_hosts, by_script(evidence)
    )
    missing = decide_missing(
        evidence,
        kind.answer,
        build_tool.answer,
        target=target,
        packages=packages,
        provided=provided(evidence, system.answer, sources.answer, everything, target),
        built=(source.name for source in sources.answer.sources),
        keys=system.answer.rosdep,
        command=command.answer.command,
        switch=build_tool.answer == "cmake" and not config.compatible,
        cloned=sources.answer.with_unknown_packages,
        may_hold=sources.answer.may_hold,
        tried=tried(sources.answer.sought),
        linked=linked(sources.answer.sought),
    )
    left_out = () if own.answer else missing.answer.packages
    steps = decide_steps(
        evidence,
        config,
        kind.answer,
        taken=(
            *(*sources.answer.names, *packages.names, *(each.name for each in downloads.answer)),
            *(name for part in python.answer.native_parts for name in part.files),
        ),
        addresses=(source.repo or "" for source in (*sources.answer.sources, *sources.answer.submodules)),
        itself=names_of_itself(evidence, folder_name, packages.names),
        added=repositories.answer,
    )
    test = decide_test(config)
    processor = decide_processor(
        evidence,
        kind.answer,
        build_tool.answer,
        packages,
        python.answer,
        as_it_is=bool(own.answer or config.compatible),
    )
    platforms = decide_platforms(
        evidence,
        config,
        kind.answer,
        base.answer.image,
        distro,
        cuda.answer.version,
        python.answer,
        everything,
        processor,
        () if own.answer else sources.answer.sources,
    )
    choices = (
        day,
        *(() if pip_day.answer and (own.answer or not python.answer.day) else (pip_day,)),
        *(kind, release, base, build_tool, layout, python, cuda, own, mended, command, test, platforms),
        *(sources, system, inside),
        *(() if own.answer else (repositories, scripts, missing, steps, variables, downloads)),
        *(
            ()
            if own.answer
            else (decide_launch_needs(evidence, config, command.answer, variables.answer, sources.answer),)
        ),
        *(() if own.answer else (decide_outside(evidence, config, kind.answer),)),
    )
    return Decision(
        kind=kind.answer,
        ros_distro=distro,
        ubuntu=base.answer.ubuntu,
        base_image=base.answer.image,
        build_tool=build_tool.answer,
        rosdep=system.answer.rosdep,
        skip_keys=system.answer.skip_keys,
        repositories=() if own.answer else repositories.answer,
        apt=system.answer.apt,
        apt_guessed=system.answer.apt_guessed,
        python=python.answer,
        pip=everything,
        compiling=compiling,
        source=(
            *sources.answer.sources,
            *(() if own.answer else without(sources.answer.sought, packages, left_out)),
        ),
        vcs=sources.answer.vcs,
        submodules=() if own.answer else sources.answer.submodules,
        apart=() if own.answer or config.compatible else apart(evidence, packages),
        inside=inside.answer,
        python_path=python_path(evidence, config, kind.answer, python.answer.projects, command.answer.page),
        variables=() if own.answer else variables.answer,
        scripts=() if own.answer else scripts.answer,
        downloads=() if own.answer else downloads.answer,
        packages=manifests_of(packages, left_out) if kind.answer in _ROS else (),
        package_names=names_of(packages, kind.answer, left_out, build_tool.answer),
        by_pages=by_pages(
            evidence,
            config,
            build_tool.answer,
            packages=packages,
            left_out=left_out,
            sources=sources.answer.sources,
            ros_distro=distro,
        ),
        left_out=left_out,
        ignored=marked(build_tool.answer, left_out, packages) if kind.answer in _ROS and not own.answer else (),
        ended=missing.answer.ended,
        lacking=() if own.answer else missing.answer.lacking,
        undeclared=missing.answer.undeclared,
        workspace=layout.answer.workspace,
        cmake_folder=layout.answer.cmake_folder,
        program_folders=layout.answer.program_folders,
        cmake_options=(
            *own_options(evidence, config, folder_name, build_tool.answer),
            *missing.answer.options,
            *options_of_program(evidence, config, build_tool.answer, command.answer.command),
        ),
        cuda_options=host_options(system.answer.apt_guessed, base.answer.ubuntu),
        header_links=linked_headers(evidence, base.answer.ubuntu),
        native=told(evidence.problems) and not config.compatible,
        compilers=own_compilers(evidence, config, folder_name) if build_tool.answer == "cmake" else (),
        dockerfile=dockerfile,
        context=own.answer.context if own.answer else None,
        bases=mended.answer,
        day=day.answer,
        command=command.answer.command,
        command_given=command.answer.given,
        command_through_entrypoint=command.answer.entrypoint,
        command_named=config.command is not None,
        command_candidates=command.answer.candidates,
        test=test.answer,
        rostests=() if own.answer else rostests(evidence, kind.answer, build_tool.answer),
        tests=() if own.answer else evidence.tests,
        ctest=runs_ctest(evidence, build_tool.answer, missing.answer.tests),
        compiles=bool(compiled(evidence)),
        without=platforms.answer.without,
        platforms=platforms.answer.built,
        platforms_refused=platforms.answer.refused,
        cuda=cuda.answer.version,
        cudnn=cuda.answer.cudnn,
        gpu=on_cuda if config.gpu is None else config.gpu,
        gui=command.answer.gui,
        ports=command.answer.ports,
        warnings=(
            *(Warning_(message=message, file=file, line=line) for message, file, line in evidence.problems),
            *(warn(message, origin) for message, origin in config.warnings),
            *(warning for choice in choices for warning in choice.warnings),
        ),
        reasons=tuple(reason for choice in choices for reason in choice.reasons),
    )
