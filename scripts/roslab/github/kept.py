"""What jobs keep as artifacts for later jobs of the run: each job's attempt, its failures and its reports.

An artifact belongs to an attempt of the run. If only failed jobs are run again, the artifacts of both attempts exist,
and the newest attempt of each platform counts. Any job of the caller may upload an artifact: this module checks the
form of what is read, ``verify`` its content.
https://docs.github.com/en/actions/how-tos/manage-workflow-runs/re-run-workflows-and-jobs
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path

from roslab.errors import ConfigurationError, Problem
from roslab.render.outcome import PlatformReport, Repair, from_json
from roslab.values.dataclass import asdict, dataclass

NAME = "job.json"


@dataclass(frozen=True, kw_only=True, slots=True)
class Job:
    """One job's attempt, as kept in its folder."""

    platform: str
    """The platform that it builds, ``""`` for a job that builds all or none."""
    attempt: int
    failures: tuple[str, ...] = ()
    repairs: tuple[Repair, ...] = ()
    reports: tuple[PlatformReport, ...] = ()
    folder: Path | None = None
    """Where the attempt was read from, with whatever else it kept."""


def begin(folder: Path, *, platform: str, attempt: int) -> None:
    """Record that an attempt of a job has begun; an earlier step of the same job may have recorded it."""
    folder.mkdir(exist_ok=True)
    if not (folder / NAME).exists():
        _write(folder, platform, attempt, ())


def fail(folder: Path, lines: Sequence[str]) -> None:
    """Record what stopped the job."""
    folder.mkdir(exist_ok=True)
    job = _job(folder / NAME) if (folder / NAME).exists() else Job(platform="", attempt=1)
    _write(folder, job.platform, job.attempt, (*job.failures, *lines), job.repairs)


def mend(folder: Path, repairs: Sequence[Repair]) -> None:
    """Record what repairs the job's build."""
    folder.mkdir(exist_ok=True)
    job = _job(folder / NAME) if (folder / NAME).exists() else Job(platform="", attempt=1)
    _write(folder, job.platform, job.attempt, job.failures, repairs)


def gather(folder: Path) -> tuple[Job, ...]:
    """Return the newest attempt of each job whose folder is anywhere below this one, by platform.

    Raises ``ConfigurationError`` for a file that this module did not write, and if two files name the same attempt.
    """
    newest: dict[str, Job] = {}
    for file in sorted(folder.rglob(NAME)):
        job = _job(file)
        other = newest.get(job.platform)
        if other and other.attempt == job.attempt:
            whose = job.platform or "the job"
            hint = "another job of the workflow uploads artifacts of that name: give its artifacts another"
            raise ConfigurationError(Problem(message=f"two reports of attempt {job.attempt} of {whose}", hint=hint))
        if not other or other.attempt < job.attempt:
            newest[job.platform] = job
    return tuple(newest.values())


def reports(jobs: Sequence[Job]) -> tuple[PlatformReport, ...]:
    """Return the reports of jobs, one for each platform."""
    return tuple({report.platform: report for job in jobs for report in job.reports}.values())


def _job(file: Path) -> Job:
    try:
        data = json.loads(file.read_text(encoding="utf-8"))
        platform, attempt, failures = data["platform"], data["attempt"], data["failures"]
        known = isinstance(platform, str) and type(attempt) is int and all(isinstance(line, str) for line in failures)
        repairs = tuple(Repair(**entry) for entry in data.get("repairs", ()))
        known = known and all(isinstance(each.file, str) and isinstance(each.text, str) for each in repairs)
        found = tuple(_reports(file.parent))
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise ConfigurationError(Problem(message=f"{file.parent.name} is no report of a job: {error}")) from None
    strange = [report.platform for report in found if platform and report.platform != platform]
    if not known or strange:
        raise ConfigurationError(Problem(message=f"{file.parent.name} is no report of a job for {platform}"))
    return Job(
        platform=platform, attempt=attempt, failures=tuple(failures), repairs=repairs, reports=found, folder=file.parent
    )


def _reports(folder: Path) -> Iterator[PlatformReport]:
    for file in sorted(folder.glob("report-*.json")):
        yield from_json(file.read_text(encoding="utf-8"))


def _write(folder: Path, platform: str, attempt: int, failures: Sequence[str], repairs: Sequence[Repair] = ()) -> None:
    content = {
        "platform": platform,
        "attempt": attempt,
        "failures": list(failures),
        "repairs": [asdict(each) for each in repairs],
    }
    (folder / NAME).write_text(json.dumps(content, indent=2) + "\n", encoding="utf-8")
