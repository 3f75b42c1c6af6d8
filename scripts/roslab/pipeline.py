"""The one way through, from a folder to a plan and to the files that are built."""

from __future__ import annotations

import os
import posixpath
from dataclasses import dataclass, fields, replace
from pathlib import Path

from roslab import config as configuration
from roslab.config import vocabulary
from roslab.config.model import Base, BuildTool, Config, Kind
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.errors import ConfigurationError, NothingToBuildError, Problem, RefusedError
from roslab.evidence.facts import Evidence
from roslab.evidence.gather import gather
from roslab.knowledge.distros import rosdistro_tag
from roslab.plan.plan import Plan, image_name, make_plan
from roslab.render import OutputFile, quote, render_all
from roslab.repository.checkout import Repository, printable
from roslab.values.origin import Place

MAX_CONFIG = 1024 * 1024
"""Bytes of a roslab.yaml: the longest of 78 real ones has two thousand."""
READMES = ("README.md", "Readme.md", "readme.md", "README.markdown", "README.rst", "README.txt", "README")
CONFIG_NAMES = ("roslab.yaml", "roslab.yml", ".roslab.yaml", "repolab.yaml")
"""Where a configuration is looked for, at the root: the first one counts."""


OWN_NAMES = ("Dockerfile", "Dockerfile.dockerignore", "docker_build.sh", "docker_run.sh", "README.ipynb")
"""What ``create`` writes, where it carries the mark."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Overrides:
    """What an action's input or a command's option says; it wins over roslab.yaml. ``None``: not said."""

    platforms: tuple[str, ...] | None = None
    command: tuple[str, ...] | str | None = None
    test: tuple[str, ...] | str | None = None
    name: str | None = None
    kind: Kind | None = None
    build: BuildTool | None = None
    base: Base | None = None
    """Its fields that are set win, the others stay as roslab.yaml has them."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Planned:
    """A plan and everything it came from."""

    repository: Repository
    evidence: Evidence
    config: Config
    decision: Decision
    plan: Plan


def plan_repository(
    path: str | Path,
    *,
    branch: str | None = None,
    config_file: str | None = None,
    overrides: Overrides | None = None,
    folder_name: str | None = None,
) -> Planned:
    """Read a repository and plan its image; nothing of it is executed and no network is used.

    ``config_file`` is relative to the repository; ``folder_name`` names the image where nothing else does.
    Raises ``ConfigurationError``, ``NothingToBuildError`` or ``RefusedError``.
    """
    repository = _without_own_files(Repository.open(path, branch=branch))
    config = _override(_read_config(repository, config_file), overrides or Overrides())
    _check_paths(config, repository)
    evidence = gather(repository)
    name = folder_name or _folder_name(repository)
    try:
        decision = decide(evidence, config, folder_name=name)
    except NothingToBuildError as error:
        found = _what_is_there(repository)
        raise NothingToBuildError(*(replace(p, message=f"{p.message}; {found}") for p in error.problems)) from None
    ignore = tuple(repository.read(".dockerignore").splitlines())
    plan = make_plan(
        decision, config, folder_name=name, ignore=ignore, rosdistro_tag=rosdistro_tag(decision.ros_distro)
    )
    return Planned(repository=repository, evidence=evidence, config=config, decision=decision, plan=plan)


def _without_own_files(repository: Repository) -> Repository:
    """Leave out what ``create`` wrote: it is no evidence, and its Dockerfile is not the author's."""
    candidates = repository.named(*OWN_NAMES)
    if not candidates:
        return repository
    from roslab.files import generated  # noqa: PLC0415 - most repositories have none of these names

    return repository.leaving_out(
        {file.path for file in candidates if generated(file.name, repository.read_bytes(file))}
    )


def _check_paths(config: Config, repository: Repository) -> None:
    """Raise ``ConfigurationError`` where roslab.yaml names a file or folder that is not there, all of them at once."""
    files = [("dockerfile", config.dockerfile), ("conda", config.conda)]
    for key, paths in (("requirements", config.requirements), ("vcs", config.vcs)):
        files += [(f"{key}.{index}", path) for index, path in enumerate(paths or ())]
    missing = [(key, path) for key, path in files if path and not repository.has(posixpath.normpath(path))]
    context = posixpath.normpath(config.context or ".")
    if context != "." and context not in repository.folders:
        missing.append(("context", context))
    problems = []
    for key, path in missing:
        outside = path in repository.listing.outside
        what = "a link that leads out of the repository" if outside else "not there"
        place = config.place(key) or config.place(key.partition(".")[0])
        problems.append(
            Problem(
                message=f"{key.partition('.')[0]}: {printable(path)} is {what}",
                hint="give a path relative to the root of the repository",
                origin=place or (Place(file=config.file) if config.file else None),
            )
        )
    if problems:
        raise ConfigurationError(*problems)


def _what_is_there(repository: Repository) -> str:
    """Say in a few words what a folder holds in which nothing was recognised."""
    counts = sorted(
        ((len(files), suffix or "without a suffix") for suffix, files in repository.by_suffix.items()), reverse=True
    )
    unread = "".join(f"; {message}" for message, _, _ in repository.problems)
    if not counts:
        return f"there is no file at all{unread}"
    kinds = ", ".join(f"{count} {printable(suffix)}" for count, suffix in counts[:5])
    more = f" and {len(counts) - 5} kinds more" if len(counts) > 5 else ""
    return f"there is only {kinds}{more}{unread}"


def _folder_name(repository: Repository) -> str:
    """Name a checkout as its origin does: a runner's folder may be called anything."""
    if repository.origin:
        return repository.origin.rstrip("/").rpartition("/")[2].removesuffix(".git")
    return repository.root.name


def config_path(repository: Repository, config_file: str | None) -> str | None:
    """Return the configuration's path, relative to the repository, ``None`` where there is none.

    Raises ``ConfigurationError`` where a named file is missing, ``RefusedError`` where it is a link out of the tree.
    """
    for name in (config_file,) if config_file else CONFIG_NAMES:
        if name in repository.listing.outside:
            raise RefusedError(
                Problem(
                    message=f"{printable(name)} is a link that leads out of the repository",
                    hint="make it a file of the repository",
                )
            )
        if repository.has(name):
            return name
    if config_file:
        raise ConfigurationError(
            Problem(
                message=f"no file {printable(config_file)} in the repository",
                hint="give a path relative to its root",
            )
        )
    return None


def config_text(repository: Repository, file: str) -> str:
    """Return a configuration's text. Raises ``ConfigurationError`` where it is too large or not UTF-8."""
    size = next(entry.size for entry in repository.files if entry.path == file)
    if size > MAX_CONFIG:
        message = f"{size} bytes, a configuration has at most {MAX_CONFIG}"
        raise ConfigurationError(Problem(message=message, origin=Place(file=file)))
    data = repository.read_bytes(file)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise ConfigurationError(
            Problem(message="not UTF-8 text", hint="save the file as UTF-8", origin=Place(file=file, line=line))
        ) from None


def _read_config(repository: Repository, config_file: str | None) -> Config:
    file = config_path(repository, config_file)
    return configuration.read(config_text(repository, file), file=file) if file else Config()


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


def write_plan(plan: Plan, root: Path, folder: Path) -> tuple[Path, Path]:
    """Do what ``write_recipe`` does with a plan that came from elsewhere; ``root`` is the checkout it was made for."""
    if authored := plan.author_dockerfile:
        return root / authored.dockerfile, root / authored.context
    context = os.path.relpath(root, folder.resolve())
    for file in render_all(plan, readme=None, output_is_root=False, context=context):
        if file.path.startswith("Dockerfile"):
            (folder / file.path).write_text(file.text, encoding="utf-8")
    return folder / "Dockerfile", root


def _override(config: Config, overrides: Overrides) -> Config:
    """Put an action's inputs over roslab.yaml: the one place where that precedence stands."""
    said = {key: value for key in Overrides.__dataclass_fields__ if (value := getattr(overrides, key)) is not None}
    if "name" in said and image_name(said["name"]) != said["name"]:
        raise ConfigurationError(
            Problem(
                message=f"{said['name']!r} is no image name",
                hint=f"write {image_name(said['name'])!r}: lower case, digits, - _ .",
            )
        )
    known = vocabulary.definition("platform")["enum"]
    if unknown := [platform for platform in said.get("platforms", ()) if platform not in known]:
        near = vocabulary.nearest(unknown[0], known)
        meant = f"did you mean {near}? " if near else ""
        raise ConfigurationError(
            Problem(message=f"{unknown[0]!r} is no platform", hint=f"{meant}allowed: {', '.join(known)}")
        )
    for key in ("command", "test"):
        value = said.get(key, ())
        for text in (value,) if isinstance(value, str) else value:
            quote.checked(text)
    if isinstance(said.get("base"), Base):
        unset = Base()
        changed = {f.name: v for f in fields(Base) if (v := getattr(said["base"], f.name)) != getattr(unset, f.name)}
        said["base"] = replace(config.base, **changed)
    return replace(config, **said)
