"""The watch over an image: built from nothing without a lock, proved, and compared with the image that was archived.

It publishes nothing. Where the source no longer makes the image and the archived one still runs, one issue says so.
"""

from __future__ import annotations

import io
import os
import tempfile
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.engine import docker as engine
from roslab.engine import registry
from roslab.engine.bases import Mended
from roslab.engine.bases import mend as mend_bases
from roslab.engine.client import login, private_client
from roslab.errors import BuildError, Problem
from roslab.explain.answer import explain as explained
from roslab.github import checkout, event, inputs, issues, secrets, tags, workflow
from roslab.github import run as runs
from roslab.github.blame import by_machine
from roslab.github.event import Event
from roslab.github.explaining import Mending, asking, mend
from roslab.github.inputs import Inputs
from roslab.github.run import Folder, Run
from roslab.lock import comparison, inventory, rot
from roslab.lock.rot import Finding, Side
from roslab.pipeline import bases_of, plan_repository, write_bases, write_plan
from roslab.plan.ladder import below
from roslab.prove import containers
from roslab.prove.ladder import climb
from roslab.render import rot as pages
from roslab.repository import git as commits
from roslab.values.dataclass import dataclass, replace

Environment = Mapping[str, str]
ATTEMPTS = 2
"""Builds in all, where the first failed by the network or a server."""
PAUSE = 20.0
"""Seconds between them."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Watch:
    """One run of the watch."""

    folder: Folder
    run: Run
    root: Path
    platform: str
    archived: str
    """The archived image by its digest, ``""`` if there is none."""
    environment: Environment

    @property
    def candidate(self) -> str:
        """Name in the engine of what is built today."""
        return runs.candidate(self.folder, self.run, self.platform)


def drift(environment: Environment) -> None:
    """Build, prove, compare, and keep the issue. INPUT_ARCHIVED names the archived image's tag, ``latest`` by default.

    Raises ``BuildError`` where nothing can be said, or neither image runs; a ``RoslabError`` for wrong inputs.
    """
    what, asked = event.read(environment), inputs.read(environment)
    workspace = Path(environment.get("GITHUB_WORKSPACE") or ".").resolve()
    root = checkout.part(workspace, asked.path)
    folder = Folder.new(environment)
    os.environ["DOCKER_CONFIG"] = str(_client(folder, asked, what, environment))
    engine.check()
    run = _run(what, asked, root, workspace)
    if run.plan.secrets or environment.get("ROSLAB_SECRETS"):
        secrets.prepare(folder, run, what, environment, Path(os.environ["DOCKER_CONFIG"]))
    watch = Watch(
        folder=folder,
        run=run,
        root=root,
        platform=engine.native_platform(),
        archived=_archived(run, environment),
        environment=environment,
    )
    finding, mending = _found(watch)
    _tell(watch, finding, mending, what)
    if finding.state in ("unknown", "broken"):
        raise BuildError(Problem(message=f"{finding.state}: {finding.today.failure}", hint=rot.MEANINGS[finding.state]))


def _client(folder: Folder, asked: Inputs, what: Event, environment: Environment) -> Path:
    """Return a docker client's folder of the job's own, logged in at the image's registry where there is a password."""
    client = private_client(folder.path / "home", environment)
    if password := environment.get("ROSLAB_TOKEN", ""):
        login(client, asked.registry, asked.username or what.actor, password)
    return client


def _run(what: Event, asked: Inputs, root: Path, workspace: Path) -> Run:
    """Plan as a build without a lock would."""
    with checkout.placed(asked.path):
        planned = plan_repository(
            root,
            branch=what.branch or None,
            config_file=asked.config,
            overrides=asked.overrides,
            folder_name=runs.image_folder_name(what.repository, asked.path),
            top=workspace,
            locked=False,
        )
    return Run(
        plan=planned.plan,
        image=inputs.image(asked, owner=what.owner, name=planned.plan.name),
        username=asked.username or what.actor,
        push=False,
        reason="the watch publishes nothing",
        cache="none",
        path=asked.path,
        revision=commits.head(workspace)[0] or what.sha,
        config=planned.config.file or "",
        variant=asked.variant,
    )


def _archived(run: Run, environment: Environment) -> str:
    """Return the archived image by its digest, ``""`` where nothing has that tag. Raises ``BuildError``."""
    tag = environment.get("INPUT_ARCHIVED", "").strip() or "latest"
    if tag.startswith("sha256:"):
        return f"{run.image}@{tag}"
    try:
        return f"{run.image}@{registry.digest_of(tags.dressed(f'{run.image}:{tag}', run.plan.tags))}"
    except BuildError as error:
        if registry.TRANSIENT.search(str(error)):
            raise
        workflow.say(f"there is no archived image: {error}")
        return ""


def _found(watch: Watch) -> tuple[Finding, Mending]:
    run = watch.run
    try:
        today, mending = _today(watch)
        kept = _prove_archived(watch) if watch.archived else None
        moved = _moved(watch) if kept and (today.proved or _is_there(watch.candidate)) else None
        return rot.judged(today, kept, moved, proofs=bool(run.plan.proofs)), mending
    finally:
        engine.remove_image(watch.candidate)


def _today(watch: Watch) -> tuple[Side, Mending]:
    """Build and prove from the source; a build that the network stopped is made once more."""
    for attempt in range(1, ATTEMPTS + 1):
        try:
            _build(watch)
            break
        except engine.FailedBuild as error:
            answer = explained(io.BytesIO(error.log.encode("utf-8", errors="replace")))
            side = Side(
                proved=False,
                by_machine=by_machine(answer, watch.environment),
                failure=f"the build failed: {error.problems[0].message}",
                output="\n".join(each.log for each in answer.explanations) or error.log,
            )
            if not side.by_machine or attempt == ATTEMPTS:
                return side, mend(answer, watch.run, watch.root, asking(watch.folder, watch.environment, watch.run))
            workflow.say("the network, a server or this machine was to blame: once more")
            time.sleep(PAUSE)
    return _proved(watch, watch.candidate), Mending(problems=())


def _build(watch: Watch) -> None:
    run = watch.run
    with tempfile.TemporaryDirectory(dir=watch.folder.path) as place:
        dockerfile, context = write_plan(run.plan, watch.root, Path(place))
        authored = run.plan.author_dockerfile
        if authored and (copy := checkout.shielded(dockerfile, context, Path(place))):
            dockerfile = copy
        with workflow.group(f"Build {run.plan.name} from nothing for {watch.platform}"):
            file = write_bases(run.plan, Path(place))
            mended = mend_bases(bases_of(run.plan), file, platforms=(watch.platform,)) if file else Mended()
            try:
                engine.build(
                    engine.Build(
                        context=context,
                        dockerfile=dockerfile,
                        platforms=(watch.platform,),
                        tags=(watch.candidate,),
                        contexts=mended.contexts,
                        arguments=authored.args if authored else (),
                        target=authored.target if authored else None,
                        secrets=secrets.held(watch.folder, run, watch.environment),
                        extra=("--no-cache", "--pull")
                        if _pulls(watch.environment) and not mended.images
                        else ("--no-cache",),
                    )
                )
            finally:
                for image in mended.images:
                    engine.remove_image(image)


def _pulls(environment: Environment) -> bool:
    """Tell whether bases are asked for anew; act's machines may have images that no registry has."""
    return environment.get("ACT") != "true"


def _prove_archived(watch: Watch) -> Side:
    try:
        registry.pull(watch.archived, watch.platform)
    except BuildError as error:
        return Side(proved=False, by_machine=bool(registry.TRANSIENT.search(str(error))), failure=str(error))
    return _proved(watch, watch.archived)


def _proved(watch: Watch, reference: str) -> Side:
    plan, pictures = watch.run.plan, watch.folder.path / "screenshots"
    with workflow.group(f"Prove {reference} on {watch.platform}"):
        outcomes = containers.prove(
            reference,
            watch.platform,
            plan.proofs,
            limits=plan.proof_limits,
            goals=plan.proof_goals,
            screenshots=pictures,
        )
    failed = [outcome for outcome in outcomes if not outcome.passed]
    if not failed:
        short = below(climb(plan.proofs, outcomes, plan.proof_goals, gpu=plan.run.gpu), plan.proof_goals.rung)
        output = "".join(outcome.output for outcome in outcomes) if short else ""
        return Side(proved=not short, failure=short or "", output=output)
    return Side(proved=False, failure=f"{failed[0].proof.name}: {failed[0].summary}", output=failed[0].output)


def _is_there(reference: str) -> bool:
    try:
        return bool(inventory.inspect(reference))
    except BuildError:
        return False


def _moved(watch: Watch) -> comparison.Comparison | None:
    try:
        old, new = (inventory.read(reference, watch.platform) for reference in (watch.archived, watch.candidate))
    except BuildError as error:
        workflow.say(f"what moved is not known: {error}")
        return None
    return comparison.compare(comparison.contents(old), comparison.contents(new), sizes=(old.size, new.size))


def _tell(watch: Watch, finding: Finding, mending: Mending, what: Event) -> None:
    """Write the summary, the outputs and the badge, and keep the issue."""
    folder, run, archived = watch.folder, watch.run, watch.archived
    folder.artifact.mkdir(exist_ok=True)
    (folder.artifact / "badge.json").write_text(pages.badge(finding.state), encoding="utf-8")
    moved = finding.moved
    workflow.outputs(
        {
            "state": finding.state,
            "moved": str(len(moved.moved)) if moved else "",
            "report": str(folder.artifact),
            "artifact": runs.artifact_name("drift", run),
        },
        watch.environment,
    )
    workflow.summary(pages.summary(finding, archived=archived), watch.environment)
    workflow.say(f"{finding.state}: {rot.counted(finding)}")
    keeper = issues.Keeper(event=what, subject=f"{run.image} {run.variant}", environment=watch.environment)
    if finding.state == "archived only":
        problems = _problems(finding, mending)
        text = pages.issue(
            finding, archived=archived, problems=problems, repairs=mending.repairs, page=what.page, commit=run.revision
        )
        keeper.tell(pages.title(run.plan.name), text)
    elif finding.today.proved:
        keeper.close(pages.repaired(run.revision, what.page))


def _problems(finding: Finding, mending: Mending) -> Sequence[str]:
    said = [str(replace(problem, origin=None)) for problem in mending.problems]
    said = said or [finding.today.failure]
    if finding.suspects:
        pins = ", ".join(f"`{c.name}=={c.old}`" for c in finding.suspects if c.kind == "pip" and c.old)
        if pins:
            said.append(f"The output names packages that moved. In roslab.yaml, `pip:` takes them as they were: {pins}")
        said.append("A roslab.lock of the archived image keeps all of them: see `roslab lock`")
    return said
