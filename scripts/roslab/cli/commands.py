"""What each command does; results go to standard output, progress to standard error."""

from __future__ import annotations

import argparse
import difflib
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from roslab.cli.arguments import OVERRIDING
from roslab.config import Override, locate
from roslab.config.generation import NAMES
from roslab.errors import BuildError, ConfigurationError, Problem
from roslab.pipeline import Planned, plan_repository
from roslab.values.origin import Option, Place


def _plan(options: argparse.Namespace) -> Planned:
    said = {option: getattr(options, key, None) for option, key in OVERRIDING.items()}
    overrides = tuple(
        Override(key=OVERRIDING[option], text=text, origin=Option(name=option))
        for option, text in said.items()
        if text is not None
    )
    return plan_repository(options.path, branch=options.branch, config_file=_named(options), overrides=overrides)


def _named(options: argparse.Namespace) -> locate.Named | None:
    return locate.Named(path=options.config, origin=Option(name="--config")) if options.config else None


def inspect(options: argparse.Namespace) -> int:
    """Print what was found and why."""
    from roslab.render import report  # noqa: PLC0415 - the other commands do without

    planned = _plan(options)
    if options.explain:
        questions = sorted({reason.question for reason in planned.decision.reasons})
        if options.explain not in questions:
            raise ConfigurationError(
                Problem(message=f"no question {options.explain!r} here", hint=f"one of: {', '.join(questions)}")
            )
        sys.stdout.write(report.explanation(planned.decision.reasons, options.explain))
    elif options.format == "json":
        sys.stdout.write(report.inspection_json(planned.decision, planned.plan))
    else:
        sys.stdout.write(report.inspection_text(planned.decision, planned.plan))
    return 0


def plan(options: argparse.Namespace) -> int:
    """Print the plan as JSON."""
    from roslab.plan.plan import to_json  # noqa: PLC0415

    sys.stdout.write(to_json(_plan(options).plan))
    return 0


def check(options: argparse.Namespace) -> int:
    """Validate roslab.yaml, and check that the repository can be planned with it."""
    planned = _plan(options)
    config = planned.config
    if options.format == "json":
        warnings = [{"message": w.message, "file": w.file, "line": w.line} for w in planned.decision.warnings]
        sys.stdout.write(
            json.dumps({"file": config.file, "format": config.generation, "warnings": warnings}, indent=2) + "\n"
        )
        return 0
    sys.stdout.write(
        f"{config.file}: valid, in {NAMES[config.generation]}\n"
        if config.file
        else "no roslab.yaml: everything comes from the repository\n"
    )
    sys.stdout.write(_warnings(planned))
    return 0


def migrate(options: argparse.Namespace) -> int:
    """Print an old roslab.yaml in today's format."""
    from roslab.config.migrate import migrate as migrated  # noqa: PLC0415
    from roslab.repository.checkout import Repository  # noqa: PLC0415

    repository = Repository.open(options.path, branch=options.branch)
    file = locate.find(repository, _named(options))
    if file is None:
        raise ConfigurationError(Problem(message="there is no roslab.yaml to migrate", hint="name it with --config"))
    migration = migrated(locate.text(repository, file), file=file)
    for change in migration.changes:
        sys.stderr.write(f"{change}\n")
    if options.write:
        from roslab.files import replace_with_backup  # noqa: PLC0415

        replace_with_backup(repository.root / file, migration.text)
    else:
        sys.stdout.write(migration.text)
    return 0


def create(options: argparse.Namespace) -> int:
    """Write the generated files to the repository's root or to ``--output``."""
    from roslab.files import write_all  # noqa: PLC0415
    from roslab.pipeline import rendered  # noqa: PLC0415

    planned = _plan(options)
    folder = Path(options.output) if options.output else planned.repository.root
    written = write_all(rendered(planned, folder), folder, force=options.force)
    for entry in written:
        sys.stdout.write(f"{entry}\n")
    sys.stderr.write(_warnings(planned))
    return 0


def build(options: argparse.Namespace) -> int:
    """Build, prove, and only then name the image; if anything fails, the name stays with the old image."""
    from roslab.engine import docker as engine  # noqa: PLC0415
    from roslab.pipeline import write_dockerfile  # noqa: PLC0415

    arguments = tuple(_argument(text) for text in options.build_arg)
    planned = _plan(options)
    sys.stderr.write(_warnings(planned))
    version = engine.check()
    screenshots = _screenshots(options, planned)
    platforms = planned.plan.platforms if options.platforms else (engine.native_platform(),)
    authored = planned.plan.author_dockerfile
    name = f"{planned.plan.name}:{options.tag}"
    engine.say(f"roslab: building {name} for {', '.join(platforms)} with Docker {version}")
    candidates: list[str] = []
    try:
        with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
            dockerfile, context = write_dockerfile(planned, Path(folder))
            for platform in platforms:
                candidates.append(f"{planned.plan.name}:roslab-candidate-{os.getpid()}-{platform.replace('/', '-')}")
                job = engine.Build(
                    context=context,
                    dockerfile=dockerfile,
                    platforms=(platform,),
                    tags=(candidates[-1],),
                    labels=engine.commit_labels(planned.repository.root),
                    arguments=(*(authored.args if authored else ()), *arguments),
                    target=authored.target if authored else None,
                    extra=("--no-cache",) if options.no_cache else (),
                )
                engine.build(job)
                if not options.no_proof:
                    _prove(planned, candidates[-1], platform, name, screenshots)
        for candidate, platform in zip(candidates, platforms, strict=True):
            # The engine's image store may hold only one platform per name, so each of several gets its own name
            suffix = f"-{platform.rpartition('/')[2]}" if len(platforms) > 1 else ""
            engine.name_image(candidate, name + suffix)
            sys.stdout.write(f"{name}{suffix}\n")
    finally:
        for candidate in candidates:
            engine.remove_image(candidate)
    return 0


def _screenshots(options: argparse.Namespace, planned: Planned) -> Path:
    """Return the folder for screenshots, which is created if one will be kept.

    By default it is in the user's cache: in the repository it would change the next image that is built.
    """
    cache = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    folder = Path(options.screenshots or Path(os.path.expanduser(cache), "roslab", planned.plan.name))  # noqa: PTH111
    if options.screenshots or (not options.no_proof and any(proof.display for proof in planned.plan.proofs)):
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            message = f"no folder {folder} can be made for screenshots: {error.strerror}"
            raise ConfigurationError(Problem(message=message, hint="name another with --screenshots DIR")) from None
    return folder.absolute()


def _prove(planned: Planned, candidate: str, platform: str, name: str, screenshots: Path) -> None:
    from roslab.prove import containers  # noqa: PLC0415

    for outcome in containers.prove(
        candidate, platform, planned.plan.proofs, limits=planned.plan.proof_limits, screenshots=screenshots
    ):
        if not outcome.passed:
            message = f"{name} was not named: on {platform}, {outcome.proof.name}: {outcome.summary}"
            raise BuildError(
                Problem(
                    message=message, hint="its output stands above; correct it, or name another `test` in roslab.yaml"
                )
            )


def run(options: argparse.Namespace) -> int:
    """Run the image with the same script that ``create`` writes as docker_run.sh."""
    from roslab.pipeline import rendered  # noqa: PLC0415

    planned = _plan(options)
    if not shutil.which("docker"):
        raise BuildError(Problem(message="docker is not installed", hint="https://docs.docker.com/engine/install/"))
    with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
        script = Path(folder) / "docker_run.sh"
        text = next(file.text for file in rendered(planned, Path(folder)) if file.path == "docker_run.sh")
        script.write_text(text, encoding="utf-8")
        arguments = ["--notebook"] if options.notebook else []
        environment = {
            **os.environ,
            "ROSLAB_IMAGE": os.environ.get("ROSLAB_IMAGE", f"{planned.plan.name}:{options.tag}"),
        }
        return subprocess.run(
            ["bash", str(script), *arguments, *options.arguments],
            env=environment,
            cwd=planned.repository.root,
            check=False,
        ).returncode


def explain(options: argparse.Namespace) -> int:
    """Print why a build failed."""
    from roslab.explain import words  # noqa: PLC0415 - tables that no other command needs
    from roslab.explain.answer import explain as explained  # noqa: PLC0415

    try:
        if options.log == "-":
            answer = explained(sys.stdin.buffer)
        else:
            with Path(options.log).open("rb") as stream:
                answer = explained(stream)
    except OSError as error:
        raise ConfigurationError(Problem(message=f"cannot read {options.log}: {error.strerror}")) from None
    sys.stdout.write(words.as_json(answer) if options.format == "json" else words.text(answer))
    if options.apply:
        _apply(options, answer.repair)
    return 0


def _apply(options: argparse.Namespace, repair: dict[str, tuple[str, ...]]) -> None:
    """Show what a repair changes in roslab.yaml, and apply it."""
    from roslab.config.addition import added  # noqa: PLC0415
    from roslab.files import replace_with_backup  # noqa: PLC0415

    if not repair:
        raise BuildError(
            Problem(message="nothing is written: no cause here has lines for roslab.yaml that are certain")
        )
    planned = _plan(options)
    if author := planned.plan.author_dockerfile:
        raise BuildError(
            Problem(
                message=f"nothing is written: the image is built from {author.dockerfile}, not from lists",
                hint="make the repair there: " + "; ".join(f"{key}: {', '.join(repair[key])}" for key in repair),
            )
        )
    file = locate.find(planned.repository, _named(options))
    old = locate.text(planned.repository, file) if file else None
    name = file or locate.NAMES[0]
    new = added(old, repair, file=name)
    if new == old:
        raise BuildError(Problem(message=f"nothing is written: {name} has these lines already"))
    lines = difflib.unified_diff((old or "").splitlines(True), new.splitlines(True), name, name)
    sys.stderr.write("".join(line if line.endswith("\n") else f"{line}\n" for line in lines))
    if file:
        replace_with_backup(planned.repository.root / file, new)
    else:
        (planned.repository.root / name).write_text(new, encoding="utf-8")


def _argument(text: str) -> tuple[str, str]:
    name, separator, value = text.partition("=")
    if not separator or not name.isidentifier():
        raise ConfigurationError(Problem(message=f"{text!r} is not NAME=VALUE", origin=Option(name="--build-arg")))
    return name, value


def _warnings(planned: Planned) -> str:
    """Return the warnings, one per line, each with its place."""
    lines = []
    for warning in planned.decision.warnings:
        place = f"{Place(file=warning.file, line=warning.line)}: " if warning.file else ""
        lines.append(f"{place}warning: {warning.message}\n")
    return "".join(lines)
