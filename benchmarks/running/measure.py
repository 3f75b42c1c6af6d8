"""One repository: planned, built, proved, its command run for a minute beside a display."""

from __future__ import annotations

import datetime as dt
import os
import shlex
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from benchmarks.running import blame, standins
from benchmarks.running.rows import Listed, Row
from benchmarks.running.standins import Base
from roslab.cli.arguments import parser
from roslab.cli.repairing import Repairing
from roslab.engine import disk
from roslab.engine import docker as engine
from roslab.engine.bases import mend
from roslab.errors import RoslabError
from roslab.knowledge.distros import python_of_ubuntu
from roslab.pipeline import Planned, bases_of, plan_repository, write_bases, write_dockerfile
from roslab.plan.plan import Plan
from roslab.plan.proof import Proof
from roslab.prove import containers
from roslab.prove.containers import Outcome
from roslab.prove.ladder import climb
from roslab.repository import git as commits

SECONDS = 60
"""Seconds for which a command is watched."""
KEPT = "20gb"
"""Of the steps of all builds, what the builder keeps: those of a list of 25 filled a disk of 90 GB."""
NO_PROGRAM = (125, 126, 127)
"""Exit codes of ``docker run`` where no program was started: https://docs.docker.com/engine/containers/run/"""


class TimeOverError(Exception):
    """A repository took longer than it may."""


@dataclass(frozen=True, kw_only=True)
class Way:
    """How repositories are measured."""

    limit: int
    """Seconds that one may take, all together."""
    logs: Path | None
    """Folder for the logs and screenshots, ``None`` to keep none."""
    make_base: Callable[[str], bool]
    """Makes the stand-in of an image that the engine lacks; tells whether it is there now."""


def measure(listed: Listed, root: Path, way: Way) -> Row:
    """Return what was seen of one repository; nothing of it stays in the engine but what the builder keeps."""
    today = dt.datetime.now(tz=dt.timezone.utc).date().isoformat()
    told: dict[str, Any] = {"repository": listed.repository, "commit": commits.head(root)[0][:7], "date": today}
    told["kind"] = listed.kind
    begun = time.monotonic()
    try:
        with _at_most(way.limit):
            told.update(_measured(listed, root, way, told))
    except TimeOverError:
        why = f"not finished in {way.limit} s, at a load of {os.getloadavg()[1]:.0f} on {os.cpu_count()} cores"
        told.update(outcome="late", why=why, seconds=round(time.monotonic() - begun, 1))
    return Row(**told)


def _measured(listed: Listed, root: Path, way: Way, told: dict[str, Any]) -> dict[str, Any]:
    """Fill ``told`` step by step, so that what was seen before the time is over stays; return what is last."""
    try:
        planned = plan_repository(root)
    except RoslabError as error:
        return {"outcome": "unplanned", "whose": "ours or the code's", "why": str(error)[:300]}
    plan = planned.plan
    told.update(planned=True, kind=plan.kind, base=plan.base_image)
    if not plan.author_dockerfile and not way.make_base(plan.base_image):
        return {"outcome": "base missing", "whose": "stand-in", "why": f"there is no {plan.base_image} here"}
    base = Base(
        name=plan.base_image,
        ubuntu=plan.ubuntu,
        python=_python(plan),
        stand_in=standins.stand_in(plan.base_image),
        lacking=standins.lacking(plan.base_image, plan.ros_distro),
    )
    told["stand_in"] = base.stand_in
    image = f"roslab-running:{listed.repository.replace('/', '-').lower()}"
    begun = time.monotonic()
    try:
        planned = _built(planned, root, image, told)
        told.update(built=True, seconds=round(time.monotonic() - begun, 1))
        return _proved(planned, image, base, way, told)
    except engine.FailedBuild as error:
        _keep(way, listed, "build.log", error.log)
        whose, cause, why = blame.of_build(error.log, base)
        outcome = "base missing" if blame.is_base(cause) else "unbuilt"
        seconds = round(time.monotonic() - begun, 1)
        return {"built": False, "outcome": outcome, "whose": whose, "cause": cause, "why": why, "seconds": seconds}
    finally:
        engine.remove_image(image)
        disk.prune(most=KEPT)


def _python(plan: Plan) -> str | None:
    """Return the plan's Python: that of a ``python:`` image, else that of its Ubuntu."""
    name, _, tag = plan.base_image.partition(":")
    return tag.partition("-")[0] if name == "python" else python_of_ubuntu().get(plan.ubuntu or "")


def _built(planned: Planned, root: Path, image: str, told: dict[str, Any]) -> Planned:
    """Build, with the repairs of ``roslab build``, whose number is told; return the plan that was built.

    Raises ``FailedBuild`` where none is left.
    """
    repairing = Repairing(options=parser("build").parse_args(["build", str(root)]), planned=planned)
    told["repairs"] = 0
    while error := _failure(repairing.planned, image):
        repairing.repair(error)
        told["repairs"] = repairing.rounds
    return repairing.planned


def _failure(planned: Planned, image: str) -> engine.FailedBuild | None:
    try:
        _build(planned, image)
    except engine.FailedBuild as error:
        return error
    return None


def _build(planned: Planned, image: str) -> None:
    """Build once, as ``roslab build`` does. Raises ``FailedBuild``."""
    authored, platform = planned.plan.author_dockerfile, engine.native_platform()
    with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
        dockerfile, context = write_dockerfile(planned, Path(folder))
        file = write_bases(planned.plan, Path(folder))
        mended = mend(bases_of(planned.plan), file, platforms=(platform,)) if file else None
        job = engine.Build(
            context=context,
            dockerfile=dockerfile,
            platforms=(platform,),
            tags=(image,),
            contexts=mended.contexts if mended else (),
            arguments=authored.args if authored else (),
            target=authored.target if authored else None,
        )
        try:
            engine.build(job)
        finally:
            for helper in mended.images if mended else ():
                engine.remove_image(helper)


def _proved(planned: Planned, image: str, base: Base, way: Way, told: dict[str, Any]) -> dict[str, Any]:
    """Prove an image as ``roslab build`` does, its command a minute long and beside a display."""
    plan = planned.plan
    # Tests that the program found by itself are left out: they say nothing of the command, and may take long
    proofs = tuple(_watched(proof) for proof in plan.proofs if proof.rung != 4 or proof.required)
    goals = replace(plan.proof_goals, seconds=SECONDS)
    with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
        screenshots = way.logs / told["repository"].replace("/", "__") if way.logs else Path(folder)
        outcomes = containers.prove(
            image, engine.native_platform(), proofs, limits=plan.proof_limits, goals=goals, screenshots=screenshots
        )
    ladder = climb(proofs, outcomes, goals, gpu=plan.run.gpu)
    told["rung"] = ladder.reached
    below = [outcome for outcome in outcomes if outcome.proof.rung == 0]
    told["imports"] = all(outcome.held for outcome in below) if below else None
    start = next((outcome for outcome in outcomes if outcome.proof.may_run_on), None)
    for outcome in outcomes:
        _keep(way, told["repository"], f"{outcome.proof.name.replace(' ', '-')}.log", outcome.output)
    if start is None:
        failed = outcomes[-1]
        whose, cause, why = blame.of_run(failed.output, base)
        return {"outcome": "refused", "whose": whose, "cause": cause, "why": f"{failed.proof.name}: {why}"}
    if start.seen.bare or start.proof.rung is None:
        return {"outcome": "shell"}
    told["command"] = shlex.join(start.proof.command) or "the image's own"
    told.update(started=start.seen.code not in NO_PROGRAM, alive=start.held, drawn=start.drawn)
    return _run(start, base)


def _watched(proof: Proof) -> Proof:
    """Give the proof of the command a display, and let an image be that has another command than the right one."""
    return replace(proof, display=True, required=False) if proof.may_run_on and proof.rung == 1 else proof


def _run(start: Outcome, base: Base) -> dict[str, Any]:
    if start.held:
        return {"outcome": "runs"}
    whose, cause, why = blame.of_run(start.output, base)
    return {"outcome": "stops", "whose": whose, "cause": cause, "why": why}


def _keep(way: Way, of: Listed | str, name: str, text: str) -> None:
    """Keep a log, where logs are kept."""
    if way.logs:
        folder = way.logs / (of if isinstance(of, str) else of.repository).replace("/", "__")
        folder.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")


@contextmanager
def _at_most(seconds: int) -> Iterator[None]:
    """Raise ``TimeOverError`` in the body after so many seconds; what it started ends as it does on Ctrl-C."""

    def over(*_: object) -> None:
        raise TimeOverError

    before = signal.signal(signal.SIGALRM, over)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)
        sys.stderr.flush()
