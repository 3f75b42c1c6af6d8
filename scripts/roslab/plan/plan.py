"""The plan: all that is built, run and published, as one versioned value; nothing after it reads the repository."""

from __future__ import annotations

import json
from typing import Any

from roslab.config.model import (
    WORKSPACE_TOOLS,
    BuildTool,
    Compatible,
    Config,
    Custom,
    Generation,
    Kind,
    ProofGoals,
    ProofLimits,
    Source,
    TagParts,
)
from roslab.decide.decision import Decision, Reason, Warning_
from roslab.errors import ConfigurationError, Problem
from roslab.knowledge.tools import PythonTools, for_old_packages, python_tools, with_setuptools
from roslab.plan.as_of import AsOf, as_of, lacking, of_day
from roslab.plan.author_dockerfile import AuthorDockerfile, author_dockerfile
from roslab.plan.author_folders import author_folders
from roslab.plan.locked import Lock
from roslab.plan.package_sources import PackageSources, package_sources
from roslab.plan.packages import data_of, image_packages
from roslab.plan.proof import Proof
from roslab.plan.proofs import proofs
from roslab.plan.python import PythonPlan, asks_for_old, python_plan
from roslab.plan.run import Run, given
from roslab.plan.upstreams import Upstream, brought, upstreams
from roslab.plan.version import SourceVersion
from roslab.plan.workspace import Workspace, custom, library, workspace
from roslab.values.dataclass import asdict, dataclass
from roslab.values.pattern import pattern

_NO_NAME = pattern(r"[^a-z0-9._-]+")
_SEPARATORS = pattern(r"[._-]*([._-])[._-]*")

VERSION = 1
"""Version of the plan's JSON; a reader refuses any other."""
SLIM = "slim"
"""The stage of the slim image, and what the names of its tags end in."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Rosdep:
    """Resolving the keys of the workspace inside the image."""

    manifests: tuple[str, ...]
    """package.xml files of the packages that are built, relative to the root."""
    skip_keys: tuple[str, ...]
    rosdistro_tag: str | None
    """Tag of ros/rosdistro whose tables still have this distribution's Ubuntu; ``None`` if the newest have it."""
    pip: bool = False
    """rosdep calls pip for some of the keys."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Plan:
    """The whole plan. Tuples keep the order in which things are applied."""

    version: int
    name: str
    """Image name without registry and owner, lower case."""
    kind: Kind
    generation: Generation
    """The format of roslab.yaml, for the report only: its effects are in the other fields."""
    compatible: Compatible | None
    """The old format that the image follows in its order of steps, its paths and its build folders."""
    ros_distro: str | None
    ubuntu: str | None
    base_image: str
    package_sources: PackageSources | None
    as_of: AsOf | None
    """Packages and clones are taken as they were on a day; ``None`` for today."""
    build_tool: BuildTool
    author_dockerfile: AuthorDockerfile | None
    repositories: tuple[str, ...]
    """PPAs, and lines of apt in which ``signed-by`` is the address of the key, added before the packages."""
    apt_first: tuple[str, ...]
    """Of an image in an old format: ROS and what every image had, installed before what the author names."""
    apt_tools: tuple[str, ...]
    """Tools that the base may already have, or that its apt may lack: installed if possible, reported if not."""
    apt: tuple[str, ...]
    apt_guessed: tuple[str, ...]
    own_packages: tuple[str, ...]
    """Packages of Debian of the repository, by paths, or that pages fetch, by addresses: if possible, else reported."""
    libraries: tuple[Source, ...]
    """Built from source before the workspace, in this order."""
    rosdep: Rosdep | None
    rosdep_keys: tuple[str, ...]
    package_data: tuple[tuple[str, str], ...]
    """Packages that need data, each with its own script that fetches them."""
    header_links: tuple[tuple[str, str], ...]
    """Headers that contradict others, each with the one that a link in its place leads to."""
    cmake_modules: tuple[str, ...]
    """Modules of CMake that the Ubuntu has where it does not look: it finds them by a link."""
    interpreters: tuple[tuple[str, str], ...]
    """Paths of Python on the author's machine that scripts name, each with the program that a link there leads to."""
    author_folders: tuple[tuple[str, str], ...]
    """Folders of the author's machine that files name, each with what a link leads to: below the home, or a path.

    ``~/NAME`` is one of the home itself."""
    python: PythonPlan
    python_tools: PythonTools
    source_version: SourceVersion | None
    """Version of projects that take it from git; ``None`` if no project does."""
    workspace: Workspace
    custom: Custom | None
    env: tuple[tuple[str, str], ...]
    notebook: bool
    slim: bool
    """The Dockerfile has a target ``slim`` too: an image of what runs, without what only building needs."""
    icub: bool
    cmake_update: str | None
    run: Run
    proofs: tuple[Proof, ...]
    proof_limits: ProofLimits
    proof_goals: ProofGoals
    platforms: tuple[str, ...]
    platforms_refused: tuple[tuple[str, str], ...]
    tags: TagParts
    secrets: tuple[str, ...]
    """Names of what single steps of the build read and no layer keeps; the values are never part of a plan."""
    ignore: tuple[str, ...]
    """Lines of the author's .dockerignore, which are kept."""
    warnings: tuple[Warning_, ...]
    reasons: tuple[Reason, ...]
    upstreams: tuple[Upstream, ...] = ()
    """What no longer answers, and what replaces it."""
    lock: Lock | None = None
    """Versions that an earlier image was made of and this one is made of again."""

    @property
    def compiled_apart(self) -> bool:
        """Whether nothing but the compilation needs the source while the image is made: it gets a stage of its own."""
        place = self.workspace
        compiled_here = place.python_projects or place.submodules or place.inside or place.scripts
        needed_later = self.custom or self.compatible or place.written_beside or compiled_here
        beside = place.ros is not None and place.ros.tool == "rosmake"  # it compiles where the source lies
        written, build = (place.program.programs, place.program.build) if place.program else ((), "")
        elsewhere = any(not f"{program}/".startswith(f"{build}/") for program in written)  # than what is brought
        return bool(place.ros or place.program) and not (needed_later or beside or elsewhere)


def image_name(text: str) -> str:
    """Return a valid image name for any text: lower case, runs of other characters become one dash.

    The grammar is the distribution project's ``path-component``:
    https://github.com/distribution/reference/blob/main/regexp.go
    """
    return _SEPARATORS.sub(r"\1", _NO_NAME.sub("-", text.lower())).strip("._-") or "image"


def make_plan(
    decision: Decision,
    config: Config,
    *,
    folder_name: str,
    ignore: tuple[str, ...] = (),
    rosdistro_tag: str | None = None,
    source_version: SourceVersion | None = None,
    unread: tuple[str, ...] = (),
) -> Plan:
    """Turn one decision into the plan of an image.

    ``folder_name`` names the image if roslab.yaml does not; ``ignore`` are the lines of the author's .dockerignore,
    ``unread`` the names at the top of the repository that no build file names.
    """
    author = author_dockerfile(decision, config)
    ros = decision.kind in ("ros1", "ros2")
    in_workspace = tuple(
        of_day(s, decision.day) for s in decision.source if ros and s.build in (*WORKSPACE_TOOLS, "none")
    )
    named = {s.name for s in in_workspace}
    libraries = tuple(s for s in decision.source if s.name not in named)
    packages = image_packages(decision, config, (*in_workspace, *decision.submodules))
    name = config.name or image_name(folder_name)
    place = workspace(decision, config, in_workspace, name, unread)
    run = Run(
        command=decision.command,
        candidates=decision.command_candidates,
        gui=decision.gui,
        gpu=decision.gpu,
        volumes=(*config.volume, *decision.volumes),
        ports=config.ports or decision.ports,
        matlab=config.matlab,
        given=given(decision),
        entrypoint_takes=decision.entrypoint_takes,
    )
    sources = package_sources(decision)
    tools = python_tools(decision.python.version, decision.ubuntu)
    tools = for_old_packages(tools) if asks_for_old(decision.python) else tools
    older = decision.python.setuptools
    tools = with_setuptools(tools, older.written) if older else tools
    return Plan(
        version=VERSION,
        name=name,
        kind=decision.kind,
        generation=config.generation,
        compatible=config.compatible,
        ros_distro=decision.ros_distro,
        ubuntu=decision.ubuntu,
        base_image=decision.base_image,
        package_sources=sources,
        as_of=as_of(decision),
        build_tool=decision.build_tool,
        author_dockerfile=author,
        repositories=(*config.repositories, *decision.repositories),
        apt_first=packages.first,
        apt_tools=packages.tools,
        apt=packages.named,
        apt_guessed=packages.without(decision.apt_guessed),
        own_packages=decision.own_packages,
        package_data=()
        if config.compatible
        else tuple((each.package, each.script.format(distro=decision.ros_distro)) for each in data_of(decision)),
        header_links=() if config.compatible else decision.header_links,
        cmake_modules=() if config.compatible else decision.cmake_modules,
        interpreters=decision.interpreters,
        author_folders=author_folders(decision, place),
        libraries=tuple(of_day(library(source, config), decision.day) for source in libraries),
        rosdep=(
            Rosdep(
                manifests=decision.packages,
                skip_keys=decision.skip_keys,
                rosdistro_tag=rosdistro_tag,
                pip=decision.rosdep_pip,
            )
            if ros and (decision.packages or in_workspace or decision.submodules)
            else None
        ),
        rosdep_keys=decision.rosdep,
        python=python_plan(decision.python, decision.compiling),
        python_tools=tools,
        source_version=source_version,
        workspace=place,
        custom=custom(config, place),
        env=config.env,
        notebook=bool(config.notebook),
        slim=_slim(decision, config),
        icub=config.base.icub,
        cmake_update=config.base.cmake_update,
        run=run,
        proofs=proofs(decision, place),
        proof_limits=config.proof,
        proof_goals=config.goals,
        platforms=decision.platforms,
        platforms_refused=decision.platforms_refused,
        tags=config.tags,
        secrets=config.secrets,
        ignore=ignore,
        warnings=(*decision.warnings, *lacking(decision)),
        reasons=decision.reasons,
        upstreams=upstreams(
            decision,
            sources=sources,
            rosdistro_tag=rosdistro_tag,
            installers=brought(tools, decision, both=bool(config.compatible), notebook=bool(config.notebook)),
            bases=author.bases if author else (),
        ),
    )


def _slim(decision: Decision, config: Config) -> bool:
    """Tell whether a slim image is wanted. Raises ``ConfigurationError`` where the author's Dockerfile is built."""
    if config.slim and decision.dockerfile:
        wrong = f"`slim` is made of a generated Dockerfile, and {decision.dockerfile} is built here"
        raise ConfigurationError(Problem(message=wrong, hint="leave `slim` out", origin=config.origin("slim")))
    return bool(config.slim)


def to_json(plan: Plan) -> str:
    """Return the plan as indented JSON, keys in the order of the fields; equal plans give equal bytes."""
    return json.dumps(asdict(plan), indent=2, ensure_ascii=True) + "\n"


def from_json(text: str) -> Plan:
    """Read a plan back. Raises ``ConfigurationError`` for anything that ``to_json`` did not write."""
    from cattrs import Converter  # noqa: PLC0415 - only a workflow's later jobs read plans: keep it off the fast path
    from cattrs.errors import BaseValidationError  # noqa: PLC0415

    try:
        data: Any = json.loads(text)
        if not isinstance(data, dict) or data.get("version") != VERSION:
            found = data.get("version") if isinstance(data, dict) else type(data).__name__
            message = f"the plan has version {found!r}, but this program reads version {VERSION}"
            raise ConfigurationError(Problem(message=message))
        converter = Converter(forbid_extra_keys=True)
        converter.register_structure_hook(
            tuple[str, ...] | str, lambda value, _: value if isinstance(value, str) else tuple(map(str, value))
        )
        return converter.structure(data, Plan)
    except (ValueError, RecursionError, BaseValidationError) as error:
        hint = "give a file that `roslab plan` wrote"
        raise ConfigurationError(Problem(message=f"not a plan: {type(error).__name__}: {error}", hint=hint)) from None
