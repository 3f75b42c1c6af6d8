"""The answer of ``roslab explain`` as values: the cause of each failed step, or the lines that matter."""

from __future__ import annotations

from typing import IO

from roslab.explain import matter, names, signatures, stages, steps
from roslab.explain.attempts import attempts, lacks
from roslab.explain.failed_packages import failed_packages
from roslab.explain.reading import Line, lines
from roslab.explain.steps import Log, Step
from roslab.knowledge.failures import of_machine
from roslab.knowledge.repairs import complete, repairs
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

KEPT = 60_000
"""Characters of a failed step that are kept for its repair."""
_AROUND = 40
"""Lines outside all steps, at the end of the log, that may say who stopped the build."""
_LEFT_OUT = pattern(r"roslab: left out: (?:apt|rosdep) (\S{1,100})[ \t\r]*$")
"""What the image's scripts say of a package that apt does not have, or of a key that rosdep or apt does not know."""
_IMAGE = pattern(r" ---> ([0-9a-f]{12})$")


@dataclass(frozen=True, kw_only=True, slots=True)
class Explanation:
    """Why one step failed."""

    step: str
    """The instruction: ``RUN make``; ``""`` if the log has no steps."""
    platform: str = ""
    file: str | None = None
    """The Dockerfile; it and its ``line`` are set if the builder names them."""
    line: int | None = None
    packages: tuple[str, ...] = ()
    """The packages in which a build tool of ROS stopped: their names, with catkin_make their folders in its ``src``."""
    error: str = ""
    """The first line that says what went wrong; ``error_line`` is its number in the log."""
    error_line: int = 0
    id: str | None = None
    """The known failure, ``None`` if there is none."""
    names: tuple[tuple[str, str], ...] = ()
    cause: str = ""
    fix: str = ""
    certainty: str = "unknown"
    repair: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """Values to add to keys of roslab.yaml."""
    lines: tuple[str, ...] = ()
    """The lines that matter, if no known failure was found."""
    reproduce: str = ""
    """The command that starts a shell where the step failed."""
    base: str = ""
    """The FROM instruction that the step builds on: ``FROM golang:1.13 AS builder``; ``""`` if the log has none."""
    user: str = ""
    """The USER instruction that the step runs under; ``""`` if the log has none."""
    log: str = field(default="", repr=False)
    """The end of the step's lines, for repairs that need more than the captured names."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Answer:
    """The result for a whole log: an explanation for each step that failed."""

    explanations: tuple[Explanation, ...]
    lines: int
    succeeded: bool
    """Whether the log is that of a successful build."""
    of_build: bool = False
    """Whether the log shows a step of a build."""
    left_out: tuple[str, ...] = ()
    """Packages and keys of rosdep that the build itself has left out, as none of its sources has them."""


def explain(stream: IO[bytes]) -> Answer:
    """Read a log and explain it; no content of a log makes it raise an error."""
    log = steps.read(lines(stream))
    failed = log.failed or ([] if log.succeeded and not log.rest.error else [log.rest])
    image = names.image(_context(log), "")
    found = tuple(_attempted(log, step, image) for step in failed)
    found = found if any(one.id for one in found) else (_stopped(log, image) or found)
    return Answer(
        explanations=_distinct(found),
        lines=log.lines,
        succeeded=log.succeeded and not log.failed,
        of_build=bool(log.steps),
        left_out=_left_out(log),
    )


def _stopped(log: Log, image: names.Image) -> tuple[Explanation, ...]:
    """Return why a build was stopped from outside, as the lines around its steps tell: a time limit, a shutdown."""
    outside = Step(lines=log.rest.lines[-_AROUND:])
    found = _step(log, outside, image) if log.failed else None
    return (found,) if found is not None and found.id in of_machine() else ()


def _left_out(log: Log) -> tuple[str, ...]:
    said = (line.text for step in (*log.steps, log.rest) for line in step.lines if line.text.startswith("roslab: left"))
    return tuple(dict.fromkeys(found[1] for text in said if (found := _LEFT_OUT.match(text))))


def _context(log: Log) -> str:
    """Return the parts of a log that name the image: its steps and their first lines."""
    parts = [step.name for step in log.steps]
    parts += [line.text for step in (log.steps or [log.rest]) for line in step.lines[:150]]
    return "\n".join(parts)[:400_000]


def _attempted(log: Log, step: Step, image: names.Image) -> Explanation:
    """Return why the last attempt of a step failed, else why what it lacks was left out after an earlier one."""
    *earlier, last = attempts(step.lines)
    step.lines = list(last.lines)
    found = _step(log, step, image)
    for attempt in reversed(earlier):
        if lacks(found.names, attempt):
            step.lines = list(attempt.lines)
            found = _step(log, step, image)
    return found


def _step(log: Log, step: Step, image: names.Image) -> Explanation:
    where = names.Image(ubuntu=image.ubuntu, ros=image.ros, instruction=step.command)
    found = signatures.match(log, step, where)
    file, line = step.place or (None, None)
    packages = failed_packages((one.text for one in step.lines), step.command)
    if found is None:
        said = matter.lines(step)
        first = matter.first_error(said)
        return Explanation(
            step=step.command,
            platform=step.platform,
            file=file,
            line=line,
            packages=packages,
            error=_short(first),
            error_line=first.number if first else 0,
            lines=tuple(_short(one) for one in matter.telling(said)),
            reproduce=reproduce(log, step),
            base=stages.base(log, step),
            user=stages.user(log, step),
            log=_kept(step),
        )
    return Explanation(
        step=step.command,
        platform=step.platform,
        file=file,
        line=line,
        packages=packages,
        error=_short(Line(0, found.said)),
        error_line=found.line.number,
        id=found.failure.id,
        names=tuple(sorted(found.names.items())),
        cause=found.cause,
        fix=found.fix,
        certainty=found.failure.certainty,
        repair=_repair(found),
        reproduce=reproduce(log, step),
        base=stages.base(log, step),
        user=stages.user(log, step),
        log=_kept(step),
    )


def _kept(step: Step) -> str:
    return "\n".join(line.text for line in step.lines[-2000:])[-KEPT:]


def _repair(found: signatures.Match) -> tuple[tuple[str, tuple[str, ...]], ...]:
    key, _, fixed = found.failure.repair.partition(":")
    if fixed:
        return ((key, tuple(fixed.split())),)
    if key == "build_args":
        return ((key, ("-j1",)),)
    if key:
        return ((key, tuple(found.names["package"].replace(",", " ").split())),) if found.known else ()
    known = repairs().get(found.failure.id)
    if known is None or known.way or not known.value or not complete(known.value, found.names):
        return ()
    return ((known.key, (signatures.filled(known.value, found.names),)),)


def reproduce(log: Log, step: Step) -> str:
    """Return the command that opens a shell where a step failed; ``""`` if the step is not known.

    The classic builder has an image of every step; buildx keeps the state of the step that failed:
    https://docs.docker.com/reference/cli/docker/buildx/debug/
    """
    if not step.command.startswith("RUN"):
        return ""
    if not step.name.startswith("[") or "] STEP " in step.name:
        lines = (line.text for earlier in log.before(step) for line in reversed(earlier.lines))
        image = next((found[1] for text in lines if (found := _IMAGE.match(text))), "")
        return f"docker run --rm -it {image} /bin/sh" if image else ""
    platform = f" --platform {step.platform}" if step.platform else ""
    file = f" --file {step.place[0]}" if step.place and step.place[0] != "Dockerfile" else ""
    return f"BUILDX_EXPERIMENTAL=1 docker buildx debug --invoke /bin/sh build{platform}{file} ."


def _short(line: Line | None) -> str:
    text = line.text.strip() if line else ""
    return text if len(text) <= 300 else f"{text[:299]}…"


def _distinct(found: tuple[Explanation, ...]) -> tuple[Explanation, ...]:
    """Drop repeated explanations of the same step, because several platforms often fail in the same way."""
    seen: dict[tuple[str, str, str], Explanation] = {}
    for one in found:
        seen.setdefault((one.step, one.platform, one.cause or one.error), one)
    return tuple(seen.values())
