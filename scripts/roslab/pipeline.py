"""From a folder to its plan, and from the plan to the files that are built."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Sequence
from typing import TYPE_CHECKING

from roslab.config import Config, Override, configure, locate
from roslab.decide import decide, nothing
from roslab.decide.decision import Decision, Warning_
from roslab.decide.logins import without_logins
from roslab.errors import ConfigurationError, NothingToBuildError, Problem
from roslab.evidence.facts import Evidence
from roslab.evidence.kept import evidence_of
from roslab.evidence.ros import vcs
from roslab.knowledge.distros import rosdistro_tag
from roslab.plan.locked import NAME as LOCK
from roslab.plan.plan import Plan, make_plan
from roslab.plan.version import SourceVersion, of_projects, source_version
from roslab.render import FILES, OutputFile, render_all
from roslab.render.output import generated
from roslab.repository import git as commits
from roslab.repository.checkout import Repository, printable
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place
from roslab.values.redacted import redacted

if TYPE_CHECKING:
    from pathlib import Path

    from roslab.engine.preflight import Finding

READMES = ("README.md", "Readme.md", "readme.md", "README.markdown", "README.rst", "README.txt", "README")
POLICY = "EXPERIMENTAL_BUILDKIT_SOURCE_POLICY"
"""Variable with the path of BuildKit's source policy, for which no command has an option.

https://docs.docker.com/build/building/variables/#experimental_buildkit_source_policy
"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Planned:
    """A plan and everything it came from."""

    repository: Repository
    config: Config
    evidence: Evidence
    decision: Decision
    plan: Plan


def plan_repository(
    path: str | Path,
    *,
    branch: str | None = None,
    config_file: locate.Named | None = None,
    overrides: Sequence[Override] = (),
    folder_name: str | None = None,
    top: Path | None = None,
    config_text: str | None = None,
    locked: bool = True,
) -> Planned:
    """Read a repository and plan its image; nothing in it is executed and no network is used.

    ``config_file`` is read in place of the roslab.yaml at the root; ``overrides`` win over what it says;
    ``folder_name`` names the image if nothing else does; ``top`` is the checkout that ``path`` is a folder of;
    ``config_text`` is read in place of the text of roslab.yaml, which need not exist then; ``locked`` plans with the
    versions of the roslab.lock beside it, if there is one.
    Raises ``ConfigurationError``, ``NothingToBuildError`` or ``RefusedError``.
    """
    repository = _without_own_files(Repository.open(path, branch=branch, top=top))
    config = _configuration(repository, config_file, overrides, config_text)
    if config.submodules == "required":
        _require_submodules(repository)
    evidence = evidence_of(repository)
    name = folder_name or repository.name
    try:
        decision = decide(evidence, config, folder_name=name)
    except NothingToBuildError as error:
        from roslab.evidence import matlab  # noqa: PLC0415 - nearly every tree has something to build
        from roslab.evidence.prose import named_branches  # noqa: PLC0415 - as above

        found = _what_is_there(repository) + nothing.of_ros(evidence, repository.suffixed(".rosinstall", ".repos"))
        if number := matlab.files(repository):
            octave = matlab.for_octave(repository)
            raise NothingToBuildError(nothing.of_matlab(number, found, octave=octave)) from None
        if repository.has("package.json"):
            raise NothingToBuildError(nothing.of_node(found)) from None
        said = tuple(replace(p, message=f"{p.message}; {found}") for p in error.problems)
        raise NothingToBuildError(*nothing.with_branches(said, named_branches.others(repository))) from None
    decision, version = _with_version(decision, evidence, repository)
    decision = _without_secrets(decision)
    plan = make_plan(
        decision,
        config,
        folder_name=name,
        ignore=tuple(repository.read(".dockerignore").splitlines()),
        rosdistro_tag=_tables(decision),
        source_version=version,
        unread=evidence.beside.unread,
    )
    hidden = () if decision.dockerfile else evidence.beside.made_elsewhere
    place = replace(plan.workspace, made_elsewhere=hidden, written_beside=evidence.beside.written_beside)
    plan = replace(plan, workspace=place)
    file = lock_file(config)
    if locked and repository.has(file):
        from roslab.plan import lock as locks  # noqa: PLC0415 - few trees have one

        plan = locks.use(plan, locks.from_text(repository.read(file), file=file), file=file)
    return Planned(repository=repository, config=config, evidence=evidence, decision=decision, plan=plan)


def lock_file(config: Config) -> str:
    """Return the path of roslab.lock, which lies beside roslab.yaml, relative to the repository."""
    return posixpath.join(posixpath.dirname(config.file or ""), LOCK)


def _tables(decision: Decision) -> str | None:
    """Return the ref of ros/rosdistro with the tables of the decision's day, else those that know its distribution."""
    if decision.day and decision.ros_distro:
        from roslab.knowledge.days import rosdistro_ref  # noqa: PLC0415 - most images are of no day

        return rosdistro_ref(decision.ros_distro, decision.day)[0]
    return rosdistro_tag(decision.ros_distro)


def read_configuration(
    path: Path, *, config_file: locate.Named | None, overrides: Sequence[Override], top: Path
) -> Config:
    """Return what roslab.yaml says of a repository, with ``overrides`` over it; the code itself is not read.

    Raises ``ConfigurationError`` or ``RefusedError``.
    """
    return _configuration(Repository.open(path, top=top), config_file, overrides)


def _require_submodules(repository: Repository) -> None:
    """Raise ``ConfigurationError`` where a submodule is not checked out."""
    if problems := [
        Problem(message=f"`submodules: required`: {message}", origin=Place(file=file, line=line))
        for message, file, line in vcs.absent(repository)
    ]:
        raise ConfigurationError(*problems)


def _with_version(
    decision: Decision, evidence: Evidence, repository: Repository
) -> tuple[Decision, SourceVersion | None]:
    """Read the version from git's tags if a project needs it; warn if the checkout has none."""
    if decision.dockerfile:
        return decision, None
    asking = of_projects(evidence.python, decision.python.projects)
    version = source_version(asking, commits.describe(repository.path) if asking else None)
    if version and not version.tag:
        first = next(iter(asking))
        message = f"its version comes from git, but no tag here has one: it is installed as {version.version}"
        warning = Warning_(message=message, file=first.file, line=first.line)
        decision = replace(decision, warnings=(*decision.warnings, warning))
    return decision, version


def _without_secrets(decision: Decision) -> Decision:
    """Return the decision without the logins and tokens that its steps would hold and its messages would quote."""
    decision = without_logins(decision)
    return replace(
        decision,
        warnings=tuple(replace(each, message=redacted(each.message)) for each in decision.warnings),
        reasons=tuple(replace(r, reason=redacted(r.reason), answer=redacted(r.answer)) for r in decision.reasons),
    )


def _without_own_files(repository: Repository) -> Repository:
    """Leave out files that ``create`` wrote: they are no evidence, and their Dockerfile is not the author's."""
    candidates = repository.named(*(posixpath.basename(file.path) for file in FILES))
    if not candidates:
        return repository
    return repository.leaving_out(
        {file.path for file in candidates if generated(file.name, repository.read_bytes(file))}
    )


def _what_is_there(repository: Repository) -> str:
    """Summarise the files of a folder in which nothing was recognised."""
    counts = sorted(
        ((len(files), suffix or "without a suffix") for suffix, files in repository.by_suffix.items()), reverse=True
    )
    unread = "".join(f"; {message}" for message, _, _ in repository.problems)
    if not counts:
        return f"there are no files{unread}"
    kinds = ", ".join(f"{count} {printable(suffix)}" for count, suffix in counts[:5])
    more = f" and {len(counts) - 5} kinds more" if len(counts) > 5 else ""
    return f"there is only {kinds}{more}{unread}"


def _configuration(
    repository: Repository, named: locate.Named | None, overrides: Sequence[Override], given: str | None = None
) -> Config:
    file = locate.find(repository, named) or (locate.NAMES[0] if given is not None else None)
    text = given if given is not None else locate.text(repository, file) if file else None
    config = configure(text, overrides, file=file)
    locate.check_paths(config, repository)
    return config


def rendered(planned: Planned, folder: Path) -> tuple[OutputFile, ...]:
    """Return the files of a plan, as they are to be written to ``folder``."""
    root = planned.repository.root
    target = folder.resolve()
    name = next((name for name in READMES if planned.repository.has(name)), None)
    return render_all(
        planned.plan,
        readme=planned.repository.read(name) if name else None,
        readme_name=name or READMES[0],
        output_is_root=target == root,
        context=os.path.relpath(root, target),
    )


def write_dockerfile(planned: Planned, folder: Path) -> tuple[Path, Path]:
    """Write what a build needs to an empty folder; return the Dockerfile to use and its context.

    The author's own Dockerfile is used where it stands.
    """
    return write_plan(planned.plan, planned.repository.root, folder)


def bases_of(plan: Plan) -> tuple[tuple[str, str], ...]:
    """Return ``(stage, name in FROM)`` of the images of the author's Dockerfile that its build replaces."""
    from roslab.render import bases  # noqa: PLC0415 - only a build asks

    found = plan.author_dockerfile.bases if plan.author_dockerfile else ()
    return tuple((bases.stage_name(number), base.name) for number, base in enumerate(found, 1))


def write_bases(plan: Plan, folder: Path) -> Path | None:
    """Write the Dockerfile of these images to a folder and return it, ``None`` if there are none."""
    if not bases_of(plan):
        return None
    from roslab.render import bases  # noqa: PLC0415 - as above

    file = folder / bases.FILE
    file.write_text(
        bases.bases(plan.author_dockerfile.bases if plan.author_dockerfile else (), plan.name), encoding="utf-8"
    )
    return file


def preflight(plan: Plan, platforms: Sequence[str]) -> tuple[Finding, ...]:
    """Return what is wrong with the base and the package source of a plan, where the network tells, with what to do."""
    import datetime as dt  # noqa: PLC0415 - only a build asks

    from roslab.engine import preflight as ask  # noqa: PLC0415 - as above
    from roslab.knowledge.keys import expires  # noqa: PLC0415 - only a build, or a key of ROS, asks

    found = ask.base(plan.base_image, platforms) if not plan.author_dockerfile else ()
    ros = plan.package_sources.ros if plan.package_sources else None
    if ros:
        instead = {None: "the build stops there", "own": "the base's own source is taken"}
        otherwise = instead.get(ros.otherwise) or f"{ros.otherwise} is taken"
        found += ask.source(ros.url, ros.ubuntu, otherwise)
        found += ask.key(ros.key, expires(ros.key), dt.datetime.now(tz=dt.timezone.utc).date().isoformat())
    return found


def write_policy(plan: Plan, folder: Path) -> dict[str, str]:
    """Write what pins the images and files of an author's own Dockerfile; return the variables that name it."""
    if not (plan.author_dockerfile and plan.lock and plan.lock.materials):
        return {}
    from roslab.lock.materials import policy  # noqa: PLC0415 - few builds have one

    file = folder / "source-policy.json"
    file.write_text(policy(plan.lock.materials), encoding="utf-8")
    return {POLICY: str(file)}


def write_plan(plan: Plan, root: Path, folder: Path) -> tuple[Path, Path]:
    """Like ``write_dockerfile``, for a plan that was made elsewhere; ``root`` is the checkout it was made for."""
    if authored := plan.author_dockerfile:
        return root / authored.dockerfile, root / authored.context
    context = os.path.relpath(root, folder.resolve())
    for file in render_all(plan, readme=None, output_is_root=False, context=context):
        if file.path.startswith("Dockerfile"):
            (folder / file.path).write_text(file.text, encoding="utf-8")
    return folder / "Dockerfile", root
