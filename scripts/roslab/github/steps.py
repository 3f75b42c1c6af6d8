"""What each step does: it reads the environment and writes outputs and files; other modules make the decisions."""

from __future__ import annotations

import json
import posixpath
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager

from roslab.engine import credentials
from roslab.engine import docker as engine
from roslab.engine.client import private_client
from roslab.errors import ConfigurationError, Problem, RoslabError
from roslab.github import (
    access,
    builder,
    checkout,
    event,
    inputs,
    kept,
    rebuild,
    report,
    secrets,
    trial,
    workflow,
)
from roslab.github import run as runs
from roslab.github import source as completion
from roslab.github.run import Folder, Run, slug
from roslab.pipeline import plan_repository
from roslab.plan.answers import answers
from roslab.plan.plan import to_json
from roslab.render.markdown import prose
from roslab.render.summary import summary as render_summary
from roslab.repository import git as commits
from roslab.values.origin import Place

Environment = Mapping[str, str]


def source(environment: Environment) -> None:
    """Complete the checkout. Raises ``RefusedError`` before anything is fetched for a stranger's code."""
    event.read(environment)
    completion.complete(checkout.workspace(environment), inputs.part(environment), environment)


def plan(environment: Environment) -> None:
    """Make the plan; this is the first step of every chain of jobs.

    Raises ``ConfigurationError``, ``NothingToBuildError`` or ``RefusedError``.
    """
    what = event.read(environment)
    asked, wrong = inputs.gather(environment)
    workspace = checkout.workspace(environment)
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
    if publication.warning:
        workflow.warn(Problem(message=publication.warning))
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
            "push": workflow.flag(run.push),
            "latest": workflow.flag(what.branch is not None and what.branch == what.default_branch),
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
    platforms = run.here(environment)
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
