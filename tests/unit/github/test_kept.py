"""What jobs keep for a later one, of several attempts and from strangers."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from roslab.errors import ConfigurationError
from roslab.github import kept
from roslab.github.run import Folder
from roslab.render.outcome import PlatformReport, ProofReport

DIGESTS = ("sha256:" + "a" * 64, "sha256:" + "b" * 64)


def report(platform: str, digest: str = DIGESTS[0], *, passed: bool = True) -> PlatformReport:
    proof = ProofReport(name="a", command="b", passed=passed, summary="c", output="d")
    return PlatformReport(
        platform=platform, digest=digest, source=digest, layers=(), proofs=(proof,), build_seconds=1.5
    )


def job(root: Path, name: str, attempt: int, *reports: PlatformReport, platform: str | None = None) -> Path:
    folder = Folder(path=root / name)
    folder.path.mkdir(parents=True)
    kept.begin(folder.artifact, platform=reports[0].platform if platform is None else platform, attempt=attempt)
    for entry in reports:
        folder.write_report(entry)
    return folder.artifact


@pytest.mark.parametrize("names", [("1", "2"), ("2", "1")], ids=["in order", "the other way round"])
def test_the_newest_attempt_of_each_platform_counts(tmp_path: Path, names: tuple[str, str]) -> None:
    """As after "re-run failed jobs": one platform from the first attempt, the other from the second."""
    first = job(tmp_path, f"arm-{names[0]}", 1, report("linux/arm64", passed=False))
    kept.fail(first, ["on linux/arm64, a: c"])
    job(tmp_path, f"arm-{names[1]}", 2, report("linux/arm64", DIGESTS[1]))
    job(tmp_path, "amd", 1, report("linux/amd64"))
    found = kept.gather(tmp_path)
    assert {entry.platform: entry.digest for entry in kept.reports(found)} == {
        "linux/amd64": DIGESTS[0],
        "linux/arm64": DIGESTS[1],
    }
    assert [line for entry in found for line in entry.failures] == []


def test_an_attempt_that_came_to_no_report_takes_the_older_ones_away(tmp_path: Path) -> None:
    job(tmp_path, "1", 1, report("linux/arm64"))
    kept.fail(job(tmp_path, "2", 2, platform="linux/arm64"), ["the build failed"])
    (found,) = kept.gather(tmp_path)
    assert found.reports == ()
    assert found.failures == ("the build failed",)


def test_two_that_claim_the_same_attempt(tmp_path: Path) -> None:
    job(tmp_path, "own", 1, report("linux/arm64"))
    job(tmp_path, "a stranger's", 1, report("linux/arm64", DIGESTS[1]))
    with pytest.raises(ConfigurationError, match="two reports of attempt 1 of linux/arm64"):
        kept.gather(tmp_path)


def test_a_job_of_one_platform_reports_no_other(tmp_path: Path) -> None:
    job(tmp_path, "own", 1, report("linux/arm64"), platform="linux/amd64")
    with pytest.raises(ConfigurationError, match="is no report of a job for linux/amd64"):
        kept.gather(tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{}",
        '{"platform": 1, "attempt": 1, "failures": []}',
        '{"platform": "", "attempt": "9", "failures": []}',
    ],
)
def test_no_job(tmp_path: Path, text: str) -> None:
    (tmp_path / kept.NAME).write_text(text)
    with pytest.raises(ConfigurationError, match="is no report of a job"):
        kept.gather(tmp_path)


@pytest.mark.parametrize(
    "changes",
    [
        {"digest": "sha256:0"},
        {"source": "latest"},
        {"source": DIGESTS[0] + "\n"},
        {"digest": DIGESTS[0].upper()},
        {"platform": 1},
        {"more": 1},
    ],
    ids=str,
)
def test_a_report_that_is_none(tmp_path: Path, changes: dict[str, object]) -> None:
    folder = job(tmp_path, "own", 1, report("linux/amd64"))
    (file,) = folder.glob("report-*.json")
    file.write_text(json.dumps({**json.loads(file.read_text()), **changes}))
    with pytest.raises(ConfigurationError, match="is no report of a job"):
        kept.gather(tmp_path)


def test_what_stopped_a_job_before_it_began(tmp_path: Path) -> None:
    kept.fail(tmp_path / "artifact", ["one", "two"])
    kept.fail(tmp_path / "artifact", ["three"])
    assert kept.gather(tmp_path)[0].failures == ("one", "two", "three")
