"""Evidence, configuration and knowledge → one decision per question, each with its reasons."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.author_dockerfile import decide_dockerfile
from roslab.decide.base import decide_base, of_dockerfile
from roslab.decide.build_tool import decide_build_tool
from roslab.decide.command import decide_command
from roslab.decide.cuda.version import CudaChoice, decide_cuda, of_image
from roslab.decide.decision import Decision, Warning_
from roslab.decide.kind import decide_kind
from roslab.decide.old_formats import folder_of_workspace, in_order, named_only, narrowed, requested, systems_python
from roslab.decide.platforms import decide_platforms
from roslab.decide.python.environment import decide_python, specifiers
from roslab.decide.ros.distro import decide_distro
from roslab.decide.ros.keys import declared_keys
from roslab.decide.ros.layout import decide_layout
from roslab.decide.ros.sources import decide_sources, with_recipes
from roslab.decide.ros.workspace import Packages, packages_of
from roslab.decide.system.names import Target
from roslab.decide.system.needs import code_needs, started
from roslab.decide.system.packages import decide_system
from roslab.errors import NothingToBuildError, Problem
from roslab.evidence.facts import Evidence
from roslab.knowledge.recipes import recipes_for

_ROS: frozenset[Kind] = frozenset({"ros1", "ros2"})


def decide(evidence: Evidence, config: Config, *, folder_name: str) -> Decision:
    """Answer every question about a repository; ``folder_name`` is its name where nothing else names it.

    roslab.yaml and the action's inputs, already one ``Config``, win over the evidence, which wins over defaults.
    Raises ``NothingToBuildError`` where there is nothing to decide on.
    """
    _something(evidence, config)
    evidence, config = narrowed(evidence, config)
    kind = decide_kind(evidence, config)
    ros = decide_distro(evidence, config, kind.kind)
    distro = ros.distro.name if ros.distro else None
    cuda = decide_cuda(evidence, config)
    if kind.kind in _ROS or kind.kind == "cpp" or distro:
        base = decide_base(evidence, config, kind.kind, chosen=ros, cuda=cuda, python=None)
        python, python_reasons, python_warnings = decide_python(evidence, config, kind.kind, base.ubuntu, distro)
    else:
        python, python_reasons, python_warnings = decide_python(evidence, config, kind.kind, config.base.ubuntu, distro)
        base = decide_base(evidence, config, kind.kind, chosen=ros, cuda=cuda, python=python.version)
    python = systems_python(python, config)
    build_tool, tool_reasons = decide_build_tool(evidence, config, kind.kind, python)
    authored = decide_dockerfile(evidence, config, kind.kind, distro)
    base = of_dockerfile(base, evidence, config, authored.dockerfile)
    cuda = of_image(cuda, base.image) if authored.dockerfile else cuda
    packages = packages_of(evidence)
    target = Target(ros_distro=distro, ubuntu=base.ubuntu)
    needed = (
        *declared_keys(packages, target, kind.kind),
        *code_needs(evidence, packages),
        *started(evidence, kind.kind),
    )
    sources = decide_sources(
        evidence,
        config,
        kind.kind,
        ros_distro=distro,
        build_tool=build_tool,
        needed=needed,
        own=packages.names,
        folder_name=folder_name,
    )
    system = decide_system(
        evidence,
        config,
        kind.kind,
        target=target,
        packages=packages,
        python=python,
        base_packages=base.ros_packages,
        sisters=sources.names,
    )
    system = requested(named_only(system, base.ros_packages, config), config, base.ubuntu)
    sources = in_order(with_recipes(sources, recipes_for((*sources.libraries, *system.recipes), base.ubuntu)), config)
    layout = folder_of_workspace(decide_layout(evidence, kind.kind, packages), config)
    on_cuda = "nvidia" in base.image or kind.kind == "cuda" or bool(config.base.cuda)
    cuda = cuda if on_cuda else CudaChoice()
    platforms = decide_platforms(evidence, config, kind.kind, base.image, distro, cuda.cuda, python)
    command = decide_command(evidence, config, kind.kind, authored.dockerfile)
    return Decision(
        kind=kind.kind,
        ros_distro=distro,
        ubuntu=base.ubuntu,
        base_image=base.image,
        build_tool=build_tool,
        rosdep=system.rosdep,
        skip_keys=system.skip_keys,
        apt=system.apt,
        apt_guessed=system.apt_guessed,
        python=python,
        pip=specifiers(evidence, python),
        source=sources.sources,
        vcs=sources.vcs,
        packages=tuple(manifest.file for manifest in packages.built) if kind.kind in _ROS else (),
        package_names=_names(packages, kind.kind),
        workspace=layout.workspace,
        cmake_folder=layout.cmake_folder,
        dockerfile=authored.dockerfile,
        context=authored.context,
        command=command.command,
        command_candidates=command.candidates,
        platforms=platforms.platforms,
        platforms_refused=platforms.refused,
        cuda=cuda.cuda,
        cudnn=cuda.cudnn,
        gpu=on_cuda if config.gpu is None else config.gpu,
        gui=command.gui if config.gui is None else config.gui,
        warnings=(
            *(Warning_(message=message, file=file, line=line) for message, file, line in evidence.problems),
            *(
                Warning_(message=message, file=place.file if place else None, line=place.line if place else None)
                for message, place in config.warnings
            ),
            *kind.warnings,
            *ros.warnings,
            *python_warnings,
            *cuda.warnings,
            *authored.warnings,
            *sources.warnings,
            *system.warnings,
        ),
        reasons=(
            *kind.reasons,
            *ros.reasons,
            *base.reasons,
            *tool_reasons,
            *layout.reasons,
            # An author's Dockerfile brings a Python of its own
            *(reason for reason in python_reasons if not (authored.dockerfile and reason.question == "python")),
            *cuda.reasons,
            *authored.reasons,
            *command.reasons,
            *platforms.reasons,
            *sources.reasons,
            *system.reasons,
        ),
    )


def _names(packages: Packages, kind: Kind) -> tuple[str, ...]:
    """Name what is found by ``rospack`` or ``ros2 pkg``; rospack knows no metapackages.

    https://github.com/ros/rospack/issues/26
    """
    built = (m for m in packages.built if kind in _ROS and not (kind == "ros1" and m.metapackage))
    return tuple(sorted(manifest.name for manifest in built if manifest.name))


def _something(evidence: Evidence, config: Config) -> None:
    """Raise where the folder holds nothing to build an image around, and roslab.yaml says nothing either."""
    found = (
        *(evidence.manifests, evidence.cmake, evidence.python, evidence.requirements, evidence.conda),
        *(evidence.dockerfiles, evidence.programs, evidence.sources, evidence.code, evidence.cuda_files),
    )
    if any(found) or config.file:
        return
    raise NothingToBuildError(
        Problem(
            message="nothing to build was found: no package.xml, CMakeLists.txt, setup.py, pyproject.toml, "
            "requirements file, conda environment, Dockerfile, Python program or C++ source",
            hint="is this the root of the repository? a roslab.yaml can say what it needs",
        )
    )
