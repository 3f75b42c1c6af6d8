"""What each step does: it reads the environment and writes outputs and files; other modules make the decisions."""

from __future__ import annotations

import json
import posixpath
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from roslab.engine import credentials
from roslab.engine import docker as engine
from roslab.engine.bases import Mended, mend
from roslab.engine.client import private_client
from roslab.errors import BuildError, ConfigurationError, Problem, RoslabError
from roslab.github import (
    access,
    builder,
    cache,
    checkout,
    disk,
    event,
    inputs,
    kept,
    locking,
    rebuild,
    report,
    secrets,
    tree,
    trial,
    workflow,
)
from roslab.github import run as runs
from roslab.github import source as completion
from roslab.github.labels import labels
from roslab.github.run import Folder, Run, slug
from roslab.pipeline import bases_of, plan_repository, preflight, write_bases, write_plan, write_policy
from roslab.plan.answers import answers
from roslab.plan.plan import to_json
from roslab.render.markdown import prose
from roslab.render.summary import summary as render_summary
from roslab.repository import git as commits
from roslab.values.origin import Place

Environment = Mapping[str, str]
NO_SLIM = "the whole image alone is published: `roslab build --slim` makes the slim one"


def source(environment: Environment) -> None:
    """Complete the checkout. Raises ``RefusedError`` before anything is fetched for a stranger's code."""
    event.read(environment)
    completion.complete(_workspace(environment), inputs.part(environment), environment)


def plan(environment: Environment) -> None:
    """Make the plan; this is the first step of every chain of jobs.

    Raises ``ConfigurationError``, ``NothingToBuildError`` or ``RefusedError``.
    """
    what = event.read(environment)
    asked, wrong = inputs.gather(environment)
    workspace = _workspace(environment)
    root = checkout.part(workspace, asked.path)
    revision = commits.head(workspace)[0] or what.sha
    tag = f"{rebuild.TAG}{asked.ref}" if asked.ref and commits.is_tag(workspace, asked.ref) else ""
    rebuilt = tag if asked.ref else None
    what = rebuild.event_of(what, rebuilt, revision)
    with _reported_with(wrong), checkout.placed(asked.path):
        planned = plan_repository(
            root,
            branch=what.branch or what.base_branch or None,
            config_file=asked.config,
            overrides=asked.overrides,
            folder_name=runs.image_folder_name(what.repository, asked.path),
            top=workspace,
        )
    pr = "none" if asked.ref else planned.config.pr  # another commit is no pull request's
    publication = event.publication(what, asked.push, pr)
    image = inputs.image(asked, owner=what.owner, name=planned.plan.name)
    if publication.push:
        given = environment.get("ROSLAB_SECRET_GIVEN") == "true"
        access.require_secret(asked.registry, name=environment.get("ROSLAB_SECRET") or "token", given=given)
    run = Run(
        plan=planned.plan,
        image=image,
        username=asked.username or what.actor,
        push=publication.push,
        reason=publication.reason,
        cache=asked.cache,
        archive=trial.wanted(what, publication, pr),
        path=asked.path,
        rebuilt=rebuilt,
        revision=revision,
        config=planned.config.file or "",
        lock=bool(planned.config.lock) and publication.push,
        variant=asked.variant,
    )
    for warning in planned.plan.warnings:
        file = posixpath.join(asked.path, warning.file) if warning.file else None
        origin = Place(file=file, line=warning.line) if file else None
        workflow.warn(Problem(message=warning.message, origin=origin))
    for told in filter(None, (publication.warning, NO_SLIM if run.plan.slim else "")):
        workflow.warn(Problem(message=told))
    folder = Folder.new(environment)
    line = runs.to_line(run)
    folder.write("run", line)
    folder.write("plan.json", to_json(run.plan))
    matrix = [
        {"platform": platform, "slug": slug(platform), "runner": inputs.runner(platform, asked.runners)}
        for platform in run.plan.platforms
    ]
    workflow.outputs(
        {
            "plan": json.dumps(answers(run.plan), separators=(",", ":")),
            "plan-file": str(folder.path / "plan.json"),
            "plan-artifact": runs.artifact_name("plan", run),
            "run": line,
            "folder": str(folder.path),
            "ref": revision if rebuilt is not None else "",
            "image": image,
            "registry": run.registry,
            "username": run.username,
            "push": _flag(run.push),
            "latest": _flag(what.branch is not None and what.branch == what.default_branch),
            "platforms": ",".join(run.plan.platforms),
            "matrix": json.dumps({"include": matrix}),
            "artifact": runs.artifact_name("image", run),
        },
        environment,
    )
    workflow.say(f"{image} from {planned.plan.base_image} for {', '.join(run.plan.platforms)}; {publication.reason}")


def ready(environment: Environment) -> None:
    """Check that the build can succeed on this machine and its result may be pushed; output which builder to use.

    A job that did not plan reads the run from ROSLAB_RUN. Raises ``BuildError``.
    """
    if environment.get("ROSLAB_RUN"):
        folder = Folder.new(environment)
        folder.write("run", environment["ROSLAB_RUN"])
    else:
        folder = Folder.of(environment)
    workflow.outputs({"folder": str(folder.path)}, environment)  # first, so that the summary can show a failure
    attempt = int(environment.get("GITHUB_RUN_ATTEMPT") or 1)
    kept.begin(folder.artifact, platform=environment.get("ROSLAB_PLATFORM", ""), attempt=attempt)
    run = folder.run
    workflow.say(f"Docker engine {engine.check()}")
    if run.push:
        right = credentials.may_push(run.image, run.username, environment.get("ROSLAB_TOKEN", ""))
        access.require(right, image=run.image, event=event.read(environment))
    platforms = _platforms(environment, run)
    lacking = builder.emulated(platforms)
    direct = not run.push and len(platforms) == 1 and not lacking
    home = folder.path / "home"
    client = private_client(home, environment)
    if "ROSLAB_SECRETS" in environment:  # a job that builds
        secrets.prepare(folder, run, event.read(environment), environment, client)
    workflow.outputs(
        {
            **builder.settings(environment, direct=direct),
            "emulate": ",".join(lacking),
            "home": str(home),
            "docker-config": str(client),
        },
        environment,
    )


def dockerfile(environment: Environment) -> None:
    """Write the Dockerfile and output everything that docker/build-push-action needs."""
    folder = Folder.of(environment)
    run = folder.run
    what = rebuild.event_of(event.read(environment), run.rebuilt, run.revision)
    root = checkout.part(_workspace(environment), run.path)
    folder.dockerfile.mkdir(exist_ok=True)
    for found in preflight(run.plan, _platforms(environment, run)):
        if found.certain:
            workflow.warn(Problem(message=found.text))
        else:
            workflow.say(found.text)
    run = replace(run, plan=locking.available(run.plan, _platforms(environment, run)))
    dockerfile, context = write_plan(run.plan, root, folder.dockerfile)
    authored = run.plan.author_dockerfile
    if authored and (copy := checkout.shielded(dockerfile, context, folder.dockerfile)):
        dockerfile = copy
        hint = "write `persist-credentials: false` below `with:` of actions/checkout"
        workflow.warn(Problem(message="the checkout left a token in .git, so the build does not see .git", hint=hint))
    revision, seconds = commits.head(root)
    if revision and run.revision and revision != run.revision:
        raise BuildError(Problem(message=f"the checkout is at {revision}, and the plan was made for {run.revision}"))
    named = labels(run.plan, what, revision=run.revision, seconds=seconds)
    platforms = _platforms(environment, run)
    disk.before_build(run, platforms, environment)
    publication = event.Publication(push=run.push, reason=run.reason)
    part = slug(platforms[0]) if len(platforms) == 1 else "all"
    layers = cache.layers(what, publication, run.cache, image=run.image, part=part, variant=run.variant)
    workflow.say(f"layer cache: {layers.reason}")
    mended = _mended(
        folder,
        run,
        platforms,
        lambda stage: cache.layers(
            what, publication, run.cache, image=run.image, part=f"{part}-{stage}", variant=run.variant
        ),
        seconds,
    )
    mounts = cache.mounts(what, run.cache, variant=run.variant)
    kept = cache.tree(what, publication, run.cache, image=run.image, part=part, variant=run.variant)
    source = tree.source_of(run.plan, root)
    carrier = tree.Carrier(plan=run.plan, folder=folder.dockerfile, platforms=platforms, mounts=mounts, source=source)
    tree.take(carrier, kept.read)
    arguments = (*(authored.args if authored else ()), ("BUILDKIT_CACHE_MOUNT_NS", mounts))
    by_digest = f"type=image,name={run.image},push=true,push-by-digest=true,name-canonical=true"
    if run.plan.as_of:
        by_digest += ",rewrite-timestamp=true"  # the same day gives the same image, whenever it is built
    loaded = f"type=docker,name={runs.candidate(folder, run, platforms[0])}" if len(platforms) == 1 else ""
    build = {
        "dockerfile": str(dockerfile),
        "context": str(context),
        "labels": "\n".join(f"{name}={value}" for name, value in named),
        # Those of the index are made with it: the build of one platform has none
        "annotations": "\n".join(f"manifest:{name}={value}" for name, value in named) if run.push else "",
        "platforms": ",".join(platforms),
        "build-args": "\n".join(f"{name}={value}" for name, value in arguments),
        "build-contexts": "\n".join(f"{name}={value}" for name, value in mended.contexts),
        "target": (authored.target or "") if authored else "",
        # A pull request's image goes straight to the engine; several platforms stay in the builder, to be loaded singly
        "exporter": by_digest if run.push else loaded or "type=cacheonly",
        "cache-from": "\n".join(layers.read),
        "cache-to": "\n".join(layers.write),
        "epoch": str(seconds) if seconds is not None else "",
        "source-policy": "".join(write_policy(run.plan, folder.dockerfile).values()),
        "provenance": ("mode=max" if what.public else "mode=min,inline-only=true") if run.push else "false",
        "sbom": builder.scanner(environment, wanted=run.push and what.public, act=what.act),
    }
    build |= secrets.outputs(secrets.held(folder, run, environment))
    later = {"started": time.time(), "tree": kept.write, "mounts": mounts, "source": source}
    folder.write("build.json", json.dumps({**build, **later}))
    workflow.outputs(build, environment)


def _mended(
    folder: Folder, run: Run, platforms: tuple[str, ...], layers: Callable[[str], cache.Layers], seconds: int | None
) -> Mended:
    """Build what replaces the images of the author's Dockerfile that no longer answer, each with a cache of its own."""
    file = write_bases(run.plan, folder.dockerfile)
    if file is None:
        return Mended()
    stages = bases_of(run.plan)
    options = {}
    for stage, _ in stages:
        cached = layers(stage)
        options[stage] = (
            *(f"--cache-from={entry}" for entry in cached.read),
            *(f"--cache-to={entry}" for entry in cached.write),
        )
    # The same commit gives the same image, so that the layers above it are found in the cache
    epoch = {} if seconds is None else {"SOURCE_DATE_EPOCH": str(seconds)}
    return mend(stages, file, platforms=platforms, options=options, environment=epoch)


def summary(environment: Environment) -> None:
    """Write the summary, also after a failure."""
    folder = Folder.of(environment)
    found = report.collect(folder, runs.reports_folder(folder, environment), event.read(environment))
    workflow.summary(render_summary(found), environment)


@contextmanager
def _reported_with(problems: tuple[Problem, ...]) -> Iterator[None]:
    """Report these problems of the inputs together with those that are raised inside."""
    try:
        yield
    except RoslabError as error:
        raise (ConfigurationError(*problems, *error.problems) if problems else error) from None
    if problems:
        raise ConfigurationError(*problems)


def nothing_built(problems: Sequence[str]) -> str:
    """Return the summary of a run that stopped before anything was decided."""
    return "### ❌ Nothing was built\n\n" + "".join(f"- {prose(problem)}\n" for problem in problems)


def _workspace(environment: Environment) -> Path:
    """Return the checkout."""
    return Path(environment.get("GITHUB_WORKSPACE") or ".").resolve()


def _platforms(environment: Environment, run: Run) -> tuple[str, ...]:
    """Return the platforms of this job: the one that it was given, otherwise all of the plan's."""
    platform = environment.get("ROSLAB_PLATFORM")
    return (platform,) if platform else run.plan.platforms


def _flag(value: bool) -> str:
    return "true" if value else "false"
