"""The plan: all that is built, run and published, as one versioned value; after it nothing reads the repository."""

from __future__ import annotations

import dataclasses
import json
import re
from dataclasses import dataclass
from typing import Any, Literal

from roslab.config.model import (
    BuildTool,
    Compatible,
    Config,
    Custom,
    Generation,
    Kind,
    Matlab,
    Source,
    TagParts,
    Volume,
)
from roslab.decide.decision import Decision, Reason, Warning_
from roslab.errors import ConfigurationError, Problem
from roslab.knowledge.tools import PythonTools, python_tools
from roslab.plan.packages import ROS_TOOLS, image_packages
from roslab.plan.proof import Proof, proofs
from roslab.plan.python import PythonPlan, python_plan
from roslab.plan.version import SourceVersion

VERSION = 1
"""Of the plan's JSON; a reader refuses another."""


@dataclass(frozen=True, kw_only=True, slots=True)
class AuthorDockerfile:
    """The author's own Dockerfile, built instead of a generated one; paths relative to the root."""

    dockerfile: str
    context: str
    args: tuple[tuple[str, str], ...] = ()
    """Build arguments."""
    target: str | None = None
    """The stage to build; ``None`` for the last one."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Rosdep:
    """Resolving the keys of the workspace inside the image."""

    manifests: tuple[str, ...]
    """package.xml files of the packages that are built, relative to the root."""
    skip_keys: tuple[str, ...]
    rosdistro_tag: str | None
    """Tag of ros/rosdistro whose tables still hold this distro's Ubuntu; ``None`` where the newest do."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Workspace:
    """What is compiled, and with which tool."""

    layout: Literal["none", "overlay", "root", "source"]
    """``overlay``: the repository lies in ``ws/src/NAME``; ``root``: the repository is the workspace itself;
    ``source``: no ROS workspace, it lies in ``$HOME/NAME``."""
    tool: BuildTool
    arguments: tuple[str, ...]
    cmake_options: str
    cmake_folder: str
    sources: tuple[Source, ...]
    """Sister packages that are cloned into the workspace."""
    python_projects: tuple[str, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Run:
    """What a container of the image needs when it is started."""

    command: tuple[str, ...] | str
    candidates: tuple[tuple[str, ...], ...]
    gui: bool
    gpu: bool
    volumes: tuple[Volume, ...]
    ports: tuple[str, ...]
    matlab: Matlab | None


@dataclass(frozen=True, kw_only=True, slots=True)
class Plan:
    """The whole plan. Tuples keep the order in which things are applied."""

    version: int
    name: str
    """Image name without registry and owner, lower case."""
    kind: Kind
    generation: Generation
    """The format that roslab.yaml is in, for the report: what it changes stands in the other fields."""
    compatible: Compatible | None
    """The old format whose ways the image keeps: its order, its paths, its folders to build in."""
    ros_distro: str | None
    ubuntu: str | None
    base_image: str
    ros_source: bool
    """The base has no ROS: its packages come from ROS's own package source."""
    build_tool: BuildTool
    author_dockerfile: AuthorDockerfile | None
    repositories: tuple[str, ...]
    """PPAs, added before the packages."""
    apt_first: tuple[str, ...]
    """Of an image in an old way: what was in every image, and ROS, before what the author names."""
    apt_tools: tuple[str, ...]
    """Tools that the base may have already or not know: installed where its apt knows them, reported where not."""
    apt: tuple[str, ...]
    apt_guessed: tuple[str, ...]
    libraries: tuple[Source, ...]
    """Built from source before the workspace, in this order."""
    rosdep: Rosdep | None
    rosdep_keys: tuple[str, ...]
    python: PythonPlan
    python_tools: PythonTools
    source_version: SourceVersion | None
    """Of projects that take their version from git; ``None`` where none does."""
    workspace: Workspace
    custom: Custom | None
    env: tuple[tuple[str, str], ...]
    notebook: bool
    icub: bool
    cmake_update: str | None
    run: Run
    proofs: tuple[Proof, ...]
    platforms: tuple[str, ...]
    platforms_refused: tuple[tuple[str, str], ...]
    tags: TagParts
    ignore: tuple[str, ...]
    """Lines of the author's .dockerignore, kept."""
    warnings: tuple[Warning_, ...]
    reasons: tuple[Reason, ...]


def image_name(text: str) -> str:
    """Return a valid image name for any text: lower case, runs of other characters become one dash.

    The grammar is the distribution project's ``path-component``:
    https://github.com/distribution/reference/blob/main/regexp.go
    """
    name = re.sub(r"[^a-z0-9._-]+", "-", text.lower())
    name = re.sub(r"[._-]*([._-])[._-]*", r"\1", name).strip("._-")
    return name or "image"


def make_plan(
    decision: Decision,
    config: Config,
    *,
    folder_name: str,
    ignore: tuple[str, ...] = (),
    rosdistro_tag: str | None = None,
    source_version: SourceVersion | None = None,
) -> Plan:
    """Turn one decision into the plan of an image.

    ``folder_name`` names the image where roslab.yaml does not; ``ignore`` are the lines of the author's .dockerignore.
    """
    author_dockerfile = (
        AuthorDockerfile(
            dockerfile=decision.dockerfile,
            context=decision.context or ".",
            args=config.args,
            target=config.target,
        )
        if decision.dockerfile
        else None
    )
    ros = decision.kind in ("ros1", "ros2")
    in_workspace = tuple(
        s for s in decision.source if ros and s.build in ("catkin_make", "catkin_tools", "colcon", "none")
    )
    libraries = tuple(s for s in decision.source if s not in in_workspace)
    packages = image_packages(decision, config, in_workspace)
    name = config.name or image_name(folder_name)
    run = Run(
        command=decision.command,
        candidates=decision.command_candidates,
        gui=decision.gui,
        gpu=decision.gpu,
        volumes=config.volume,
        ports=config.ports,
        matlab=config.matlab,
    )
    return Plan(
        version=VERSION,
        name=name,
        kind=decision.kind,
        generation=config.generation,
        compatible=config.compatible,
        ros_distro=decision.ros_distro,
        ubuntu=decision.ubuntu,
        base_image=decision.base_image,
        ros_source=ros and not decision.dockerfile and not _has_ros(decision.base_image),
        build_tool=decision.build_tool,
        author_dockerfile=author_dockerfile,
        repositories=config.repositories,
        apt_first=packages.first,
        apt_tools=packages.tools,
        apt=packages.named,
        apt_guessed=decision.apt_guessed,
        libraries=libraries,
        rosdep=(
            Rosdep(manifests=decision.packages, skip_keys=decision.skip_keys, rosdistro_tag=rosdistro_tag)
            if ros and (decision.packages or in_workspace)
            else None
        ),
        rosdep_keys=decision.rosdep,
        python=python_plan(decision.python),
        python_tools=python_tools(decision.python.version, decision.ubuntu),
        source_version=source_version,
        workspace=_workspace(decision, config, in_workspace),
        custom=config.custom,
        env=config.env,
        notebook=bool(config.notebook),
        icub=config.base.icub,
        cmake_update=config.base.cmake_update,
        run=run,
        proofs=proofs(decision),
        platforms=decision.platforms,
        platforms_refused=decision.platforms_refused,
        tags=config.tags,
        ignore=ignore,
        warnings=decision.warnings,
        reasons=decision.reasons,
    )


def _has_ros(image: str) -> bool:
    """Tell whether a base has ROS by its name; one of the author's own that has it all the same gets nothing twice."""
    return bool(re.match(r"(?:[^/]+/)*ros:", image))


def _workspace(decision: Decision, config: Config, in_workspace: tuple[Source, ...]) -> Workspace:
    layout: Literal["none", "overlay", "root", "source"] = "source"
    if decision.kind in ("ros1", "ros2") and decision.build_tool not in ROS_TOOLS:
        pass  # cmake or nothing: the repository is no package of a workspace, its sisters may be
    elif decision.workspace != "none":
        layout = decision.workspace
    elif in_workspace:
        layout = "none"  # only sister packages are compiled; the repository itself is copied beside them
    return Workspace(
        layout=layout,
        tool=decision.build_tool,
        arguments=config.build_args,
        cmake_options=config.cmake_options,
        cmake_folder=decision.cmake_folder,
        sources=in_workspace,
        python_projects=decision.python.projects,
    )


def to_json(plan: Plan) -> str:
    """Return the plan as indented JSON, keys in the order of the fields, the same bytes for the same plan."""
    return json.dumps(dataclasses.asdict(plan), indent=2, ensure_ascii=True) + "\n"


def from_json(text: str) -> Plan:
    """Read a plan back. Raises ``ConfigurationError`` for anything that ``to_json`` did not write."""
    from cattrs import Converter  # noqa: PLC0415 - only a workflow's later jobs read plans: keep it off the fast path
    from cattrs.errors import BaseValidationError  # noqa: PLC0415

    try:
        data: Any = json.loads(text)
        if not isinstance(data, dict) or data.get("version") != VERSION:
            found = data.get("version") if isinstance(data, dict) else type(data).__name__
            raise ConfigurationError(
                Problem(message=f"a plan of version {found!r}, this program reads version {VERSION}")
            )
        converter = Converter(forbid_extra_keys=True)
        converter.register_structure_hook(
            tuple[str, ...] | str,
            lambda value, _: value if isinstance(value, str) else tuple(map(str, value)),
        )
        return converter.structure(data, Plan)
    except (ValueError, RecursionError, BaseValidationError) as error:
        hint = "give a file that `roslab plan` wrote"
        raise ConfigurationError(Problem(message=f"not a plan: {type(error).__name__}: {error}", hint=hint)) from None
