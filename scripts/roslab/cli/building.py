"""``roslab build``: builds an image, proves it, and only then names it; after a repair it builds again."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import uuid
from pathlib import Path

from roslab.cli.planning import planned_of, warnings_of
from roslab.cli.repairing import Repairing
from roslab.cli.rounds import Check, Made, better, first
from roslab.engine import docker as engine
from roslab.engine import gpu
from roslab.engine.bases import Mended, mend
from roslab.engine.secrets import of_environment
from roslab.errors import BuildError, ConfigurationError, Problem
from roslab.pipeline import Planned, bases_of, preflight, write_bases, write_dockerfile, write_policy
from roslab.plan import record
from roslab.plan.ladder import LOWER, Ladder, below, lines, missed
from roslab.plan.plan import SLIM
from roslab.repository import git as commits
from roslab.values.dataclass import replace
from roslab.values.origin import Option


def build(options: argparse.Namespace) -> int:
    """Build, prove, and only then name the image; if anything fails, the name stays with the old image."""
    arguments = tuple(_argument(text) for text in options.build_arg)
    if options.write and not options.repair:
        raise ConfigurationError(
            Problem(message="writes what a repair adds, and was given with --no-repair", origin=Option(name="--write"))
        )
    planned = planned_of(options)
    sys.stderr.write(warnings_of(planned))
    version = engine.check()
    engine.say(f"roslab: Docker {version}")
    if options.twice:
        _twice(options, planned, arguments)
        return 0
    if not options.repair:
        _print(_once(options, planned, arguments))
        return 0

    def once(planned: Planned, check: Check) -> Made:
        return _once(options, planned, arguments, again=repairing.rounds > 0, check=check)

    repairing = Repairing(options=options, planned=planned, arguments=arguments)
    made = better(once, repairing, first(once, repairing))
    repairing.finish()
    _print(made)
    return 0


def _print(made: Made) -> None:
    sys.stdout.write("".join(f"{name}\n" for name, _ in made.images))


def _once(
    options: argparse.Namespace,
    planned: Planned,
    arguments: tuple[tuple[str, str], ...],
    *,
    again: bool = False,
    check: Check = lambda _: None,
) -> Made:
    """Build, prove and name once; ``again`` takes every layer that an earlier round built from the cache.

    ``check`` raises where what was made is not to be named. Raises ``FailedBuild`` if the build or a proof fails.
    """
    secrets = of_environment(planned.plan.secrets, os.environ)
    screenshots = _screenshots(options, planned)
    platforms = planned.plan.platforms if options.platforms else (engine.native_platform(),)
    if planned.plan.lock:
        from roslab.cli.locking import available, compared  # noqa: PLC0415 - the other builds do without

        planned = available(planned, platforms)
    authored = planned.plan.author_dockerfile
    name = f"{planned.plan.name}:{options.tag}"
    if not again:
        for found in preflight(planned.plan, platforms):
            engine.say(f"roslab: warning: {found.text}")
    engine.say(f"roslab: building {name} for {', '.join(platforms)}")
    anew = _from_nothing() if options.no_cache and not again else ()
    candidates: list[tuple[str, str]] = []
    helpers: list[str] = []
    labels: dict[str, str] = {}
    ladders: dict[str, Ladder] = {}
    dead: engine.FailedBuild | None = None
    try:
        with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
            dockerfile, context = write_dockerfile(planned, Path(folder))
            for platform in platforms:
                mended = _mended(planned, Path(folder), platform)
                helpers += mended.images
                candidate = f"{planned.plan.name}:roslab-candidate-{os.getpid()}-{platform.replace('/', '-')}"
                # The engine's image store may hold only one platform per name, so each of several gets its own name
                suffix = f"-{platform.rpartition('/')[2]}" if len(platforms) > 1 else ""
                job = engine.Build(
                    context=context,
                    dockerfile=dockerfile,
                    platforms=(platform,),
                    tags=(candidate,),
                    labels=engine.commit_labels(planned.repository.root),
                    contexts=mended.contexts,
                    arguments=(*(authored.args if authored else ()), *arguments, *anew),
                    target=authored.target if authored else None,
                    secrets=secrets,
                    extra=("--no-cache",) if anew else (),
                )
                for each, ending in _images(planned, job):
                    made = each.tags[0]
                    candidates.append((made, name + ending + suffix))
                    engine.build(each, environment=write_policy(planned.plan, Path(folder)))
                    if not options.no_proof:
                        ladder, died = proved(planned, made, platform, f"{name}{ending} was not named", screenshots)
                        dead = dead or (None if ending else died)
                        ladders[made] = ladder
                        labels[made] = record.to_json(record.record(planned.plan, {platform: ladder}))
                if planned.plan.lock:
                    compared(planned, candidate, platform)
        whole = Made(images=tuple((final, ladders.get(made)) for made, final in candidates), missed=dead)
        check(whole)
        for made, final in candidates:
            engine.name_image(made, final, (record.KEY, labels[made]) if labels else None)
        return whole
    finally:
        for image in (*(made for made, _ in candidates), *helpers):
            engine.remove_image(image)


def _images(planned: Planned, whole: engine.Build) -> tuple[tuple[engine.Build, str], ...]:
    """Return the builds of a platform, that of the whole image first, and what each adds to the image's name.

    The slim image is made out of the whole one, whose steps are in the cache then.
    """
    if not planned.plan.slim:
        return ((whole, ""),)
    ending = f"-{SLIM}"
    return (whole, ""), (replace(whole, tags=(whole.tags[0] + ending,), target=SLIM, extra=()), ending)


def _mended(planned: Planned, folder: Path, platform: str) -> Mended:
    """Return what replaces the images of the author's Dockerfile that no longer answer."""
    file = write_bases(planned.plan, folder)
    return mend(bases_of(planned.plan), file, platforms=(platform,)) if file else Mended()


def _from_nothing() -> tuple[tuple[str, str], ...]:
    """Return the argument that gives a build empty cache mounts, which ``--no-cache`` alone leaves as they are.

    https://docs.docker.com/build/buildkit/frontend/
    """
    return (("BUILDKIT_CACHE_MOUNT_NS", uuid.uuid4().hex),)


def _twice(options: argparse.Namespace, planned: Planned, arguments: tuple[tuple[str, str], ...]) -> None:
    """Build an image twice from nothing and compare the bits; times are the commit's.

    Raises ``BuildError`` that names the files that differ.
    """
    from roslab.engine.twice import differences  # noqa: PLC0415 - for this option alone

    authored = planned.plan.author_dockerfile
    platforms = planned.plan.platforms if options.platforms else (engine.native_platform(),)
    seconds = commits.head(planned.repository.root)[1] or 0
    with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
        dockerfile, context = write_dockerfile(planned, Path(folder))
        for platform in platforms:
            mended = _mended(planned, Path(folder), platform)
            archives = [Path(folder, f"{name}.tar") for name in ("first", "second")]
            for archive in archives:
                engine.say(f"roslab: the {archive.stem} build for {platform}")
                job = engine.Build(
                    context=context,
                    dockerfile=dockerfile,
                    platforms=(platform,),
                    labels=engine.commit_labels(planned.repository.root),
                    contexts=mended.contexts,
                    arguments=(*(authored.args if authored else ()), *arguments, *_from_nothing()),
                    target=authored.target if authored else None,
                    # Nobody keeps the archives: the quickest compression
                    output=f"type=oci,dest={archive},rewrite-timestamp=true,compression=gzip,compression-level=1",
                    secrets=of_environment(planned.plan.secrets, os.environ),
                    extra=("--no-cache", "--provenance=false"),
                )
                engine.build(job, environment={"SOURCE_DATE_EPOCH": str(seconds)})
            if found := differences(*archives):
                listed = "\n".join(f"  {line}" for line in found)
                message = f"two builds of one commit differ on {platform}:\n{listed}"
                raise BuildError(Problem(message=message))
            for image in mended.images:
                engine.remove_image(image)
            sys.stdout.write(f"{platform}: two builds, the same bits\n")


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


def prove(planned: Planned, candidate: str, platform: str, otherwise: str, screenshots: Path) -> Ladder:
    """Prove an image, and return how far it got.

    Raises ``FailedBuild`` or ``BuildError``, whose message begins with ``otherwise``.
    """
    return proved(planned, candidate, platform, otherwise, screenshots)[0]


def proved(
    planned: Planned, candidate: str, platform: str, otherwise: str, screenshots: Path
) -> tuple[Ladder, engine.FailedBuild | None]:
    """Prove an image as ``prove`` does; return its ladder, and how its command died where no proof depends on that."""
    from roslab.prove import containers  # noqa: PLC0415
    from roslab.prove.ladder import climb  # noqa: PLC0415

    plan = planned.plan
    outcomes = containers.prove(
        candidate,
        platform,
        plan.proofs,
        limits=plan.proof_limits,
        goals=plan.proof_goals,
        screenshots=screenshots,
        gpus=plan.run.gpu and bool(gpu.usable()),
    )
    for outcome in outcomes:
        if not outcome.passed:
            message = f"{otherwise}: on {platform}, {outcome.proof.name}: {outcome.summary}"
            hint = "its output stands above; correct it, or name another `test` in roslab.yaml"
            raise engine.FailedBuild(Problem(message=message, hint=hint), log=outcome.output)
    ladder = climb(plan.proofs, outcomes, plan.proof_goals, gpu=plan.run.gpu)
    engine.say("".join(f"[{platform}] {line}\n" for line in lines(ladder)).rstrip())
    dead = next((outcome.output for outcome in outcomes if outcome.proof.rung == 1 and missed(ladder, 1)), None)
    if short := below(ladder, plan.proof_goals.rung):
        problem = Problem(message=f"{otherwise}: on {platform}, {short}", hint=LOWER)
        raise BuildError(problem) if dead is None else engine.FailedBuild(problem, log=dead)
    if dead is None:
        return ladder, None
    return ladder, engine.FailedBuild(Problem(message=f"on {platform}, the default command does not start"), log=dead)


def _argument(text: str) -> tuple[str, str]:
    name, separator, value = text.partition("=")
    if not separator or not name.isidentifier():
        raise ConfigurationError(Problem(message=f"{text!r} is not NAME=VALUE", origin=Option(name="--build-arg")))
    return name, value
