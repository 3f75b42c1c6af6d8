"""All questions in their order: what is answered is known to those that come later."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.assembled import Choices, decision_of
from roslab.decide.author_dockerfile import decide_dockerfile
from roslab.decide.authored import as_authored
from roslab.decide.authors_clones import authors_clones
from roslab.decide.base import decide_base
from roslab.decide.build_tool import decide_build_tool
from roslab.decide.chains import decide_bases
from roslab.decide.clones_day import decide_clones_day
from roslab.decide.command import decide_command
from roslab.decide.cuda.for_packages import in_no_image
from roslab.decide.cuda.source_packages import with_too_old_sources
from roslab.decide.cuda.toolkit import by_script, decide_toolkit
from roslab.decide.cuda.unnamed import where_unnamed
from roslab.decide.cuda.version import decide_cuda
from roslab.decide.day import decide_days
from roslab.decide.decision import Decision
from roslab.decide.downloads import decide_downloads
from roslab.decide.kind import decide_kind
from roslab.decide.launch_needs import packages_lacking
from roslab.decide.nothing import require_something
from roslab.decide.of_kind import of_kind
from roslab.decide.old_formats import as_it_was, narrowed
from roslab.decide.platforms import decide_platforms
from roslab.decide.processor import decide_processor
from roslab.decide.proof import decide_test
from roslab.decide.python.alternatives import one_way
from roslab.decide.python.compiling import decide_compiling
from roslab.decide.python.environment import decide_python
from roslab.decide.python.installed import installed
from roslab.decide.python.of_lost_extensions import with_lost_extensions
from roslab.decide.python.other_environments import of_one_environment
from roslab.decide.python.own import decide_version
from roslab.decide.python.pins import pins
from roslab.decide.ros.distro import decide_distro
from roslab.decide.ros.filled_refs import with_refs
from roslab.decide.ros.itself import names_of_itself
from roslab.decide.ros.layout import decide_layout
from roslab.decide.ros.other_dockerfiles import without_their_clones
from roslab.decide.ros.sought import tried
from roslab.decide.ros.sources import decide_sources
from roslab.decide.ros.used import asked
from roslab.decide.ros.workspace import of_one_ros, packages_of
from roslab.decide.sought_launches import with_found_by_launches
from roslab.decide.steps import decide_steps
from roslab.decide.switched_off import without_what_is_lacking
from roslab.decide.system.apt_sources import decide_apt_sources
from roslab.decide.system.as_tried import as_tried
from roslab.decide.system.beside_libraries import with_libraries
from roslab.decide.system.gazebo import with_release
from roslab.decide.system.guards import required_by_command
from roslab.decide.system.inside import compiled_inside
from roslab.decide.system.libraries import decide_libraries
from roslab.decide.system.missing import decide_missing, provided
from roslab.decide.system.names import Target
from roslab.decide.system.of_vendors import may_lack
from roslab.decide.system.own_scripts import decide_scripts
from roslab.decide.system.packages import decide_system
from roslab.decide.system.sections import of_this_ubuntu
from roslab.decide.system.sought_libraries import with_tried
from roslab.decide.variables import decide_variables
from roslab.evidence.facts import Evidence


def decide(evidence: Evidence, config: Config, *, folder_name: str) -> Decision:
    """Answer every question about a repository, as the room's ``decide`` says."""
    require_something(evidence, config, folder_name)
    evidence, config = narrowed(evidence, config)
    day, pip_day, evidence = decide_days(of_one_environment(evidence, config), config)
    kind = decide_kind(evidence, config, folder_name)
    evidence = of_kind(evidence, kind.answer, folder_name)
    release = decide_distro(evidence, config, kind.answer)
    distro = release.answer.name if release.answer else None
    evidence = without_their_clones(evidence, distro)
    cuda = decide_cuda(evidence, config, pins(evidence))
    evidence = with_refs(one_way(evidence, cuda.answer.version), distro)
    mentioned = pins(evidence)
    version = decide_version(evidence, config, kind.answer, pins=mentioned, ros_distro=distro, cuda=cuda.answer.version)
    cuda = where_unnamed(cuda, evidence, config, kind.answer, version.answer, release.answer)
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
    evidence, command = without_what_is_lacking(
        evidence, config, decide_command(evidence, config, kind.answer, dockerfile, python.answer.version), distro
    )
    evidence = of_this_ubuntu(
        required_by_command(evidence, command.answer.command, kind.answer), base.answer.ubuntu, distro
    )
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
    sources = with_found_by_launches(
        decide_sources(
            evidence,
            config,
            kind.answer,
            ros_distro=distro,
            build_tool=build_tool.answer,
            needed=asked(evidence, packages, target, kind.answer, everything),
            own=packages.names,
            folder_name=folder_name,
            launched=packages_lacking(evidence, config, command.answer.command, distro),
        ),
        evidence,
        config,
        command.answer.command,
        ros_distro=distro,
        build_tool=build_tool.answer,
        installed=everything,
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
    everything = installed(evidence, python.answer) if config.compatible else everything
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
    sources = with_tried(
        sources, libraries, config, evidence, kind.answer, target=target, packages=packages, system=system.answer
    )
    system = may_lack(
        with_release(with_libraries(system, libraries, evidence, config, target), evidence, target),
        base.answer,
        config.apt,
    )
    repositories = decide_apt_sources(
        evidence, config, {*system.answer.apt, *system.answer.apt_guessed}, base.answer.ubuntu, base.answer.image
    )
    inside = compiled_inside(evidence, config, kind.answer)
    scripts = decide_scripts(evidence, config, kind.answer, inside, python.answer.projects, target=target)
    projects = [project for project in evidence.python if (project.folder or ".") in python.answer.projects]
    page, parts = command.answer.page, python.answer.native_parts
    downloads = decide_downloads(evidence, config, command.answer.command, folder_name, page=page, parts=parts)
    variables = decide_variables(
        evidence,
        config,
        base.answer.ubuntu,
        (*everything, *(each for project in projects for each in project.build_requires)),
        command=page,
        argv=command.answer.command,
        image=base.answer.image,
        ros=distro,
        gui=command.answer.gui,
        dockerfile=dockerfile,
        apt=frozenset((*system.answer.apt, *system.answer.apt_guessed, *map(target.ros, system.answer.rosdep))),
        downloads=downloads.answer,
        libraries=(source.name for source, _ in libraries),
    )
    on_cuda = "nvidia" in base.answer.image or kind.answer == "cuda" or bool(config.base.cuda)
    cuda = with_too_old_sources(cuda, everything) if on_cuda else in_no_image(cuda)
    compiling = decide_compiling(
        projects, (*everything, *python.answer.first), cuda.answer.version, evidence, by_script(evidence)
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
        config=config,
    )
    left_out, sources, system = as_tried(
        sources, system, missing.answer, evidence, config, packages=packages, command=command.answer, own=own.answer
    )
    steps = decide_steps(
        evidence,
        config,
        kind.answer,
        taken=(
            *(*sources.answer.names, *packages.names, *(each.name for each in downloads.answer)),
            *(name for part in parts for name in part.files),
        ),
        addresses=(each.repo or "" for each in sources.answer.everything),
        itself=names_of_itself(evidence, folder_name, packages.names),
        added=repositories.answer,
        fetched=(each.url for each in downloads.answer),
        system=system.answer,
    )
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
        apt=() if own.answer else system.answer.installed,
        ubuntu=base.answer.ubuntu,
    )
    return decision_of(
        Choices(
            day=day,
            pip_day=pip_day,
            kind=kind,
            release=release,
            base=base,
            build_tool=build_tool,
            layout=layout,
            python=with_lost_extensions(python, missing.answer.extensions, evidence),
            cuda=cuda,
            own=own,
            mended=mended,
            command=command,
            test=decide_test(config),
            platforms=platforms,
            sources=authors_clones(sources, evidence, dockerfile, config, target=target, build_tool=build_tool.answer),
            system=system,
            inside=inside,
            repositories=repositories,
            scripts=scripts,
            missing=missing,
            steps=steps,
            variables=variables,
            downloads=downloads,
            packages=packages,
            target=target,
            everything=everything,
            compiling=compiling,
            clones_day=decide_clones_day(evidence, config, build_tool.answer, scripts.answer),
            dockerfile=dockerfile,
            on_cuda=on_cuda,
            left_out=left_out,
        ),
        evidence,
        config,
        folder_name=folder_name,
    )
