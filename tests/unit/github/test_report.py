"""What the steps and jobs of a run kept becomes one report."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from roslab.github import kept, report
from roslab.github.event import Event
from roslab.github.run import Folder, Run, to_line
from roslab.pipeline import plan_repository
from roslab.render.outcome import PlatformReport, ProofReport, Report
from roslab.render.summary import summary

EVENT = Event(
    name="push", repository="lab/robot", ref="refs/heads/main", sha="", default_branch="main", workflow_file="image.yml"
)
DIGEST = "sha256:" + "a" * 64


@pytest.fixture
def folder(tmp_path: Path, examples: Path) -> Folder:
    plan = plan_repository(examples / "ros2_filter", folder_name="robot").plan
    run = Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=True, reason="it is a push", cache="auto")
    found = Folder(path=tmp_path)
    kept.begin(found.artifact, platform="", attempt=1)
    found.write("run", to_line(run))
    proof = ProofReport(name="test", command="true", passed=True, summary="passed", output="")
    for platform in ("linux/arm64", "linux/amd64"):
        found.write_report(
            PlatformReport(
                platform=platform, digest=DIGEST, source=DIGEST, layers=(), proofs=(proof,), build_seconds=1.0
            )
        )
    return found


def published(folder: Folder, public: object) -> Report:
    content = {"digest": DIGEST, "tags": ["ghcr.io/lab/robot:main"], "public": public}
    folder.write("published.json", json.dumps(content))
    return report.collect(folder, folder.artifact, EVENT)


def test_published(folder: Folder) -> None:
    found = published(folder, True)
    assert found.published
    assert [entry.platform for entry in found.platforms] == ["linux/amd64", "linux/arm64"]
    assert found.badge == (
        "[![image](https://github.com/lab/robot/actions/workflows/image.yml/badge.svg?branch=main)]"
        "(https://github.com/lab/robot/pkgs/container/robot)"
    )
    assert "Anybody may pull this image." in summary(found)


def test_a_private_package_says_how_to_open_it(folder: Folder) -> None:
    text = summary(published(folder, False))
    assert "**The package is private**" in text
    assert "https://github.com/lab/robot/pkgs/container/robot" in text
    assert published(folder, None).notes == ()


def test_a_signature_comes_with_the_line_that_checks_it(folder: Folder) -> None:
    line = ["gh attestation verify", f"oci://ghcr.io/lab/robot@{DIGEST}", "--repo lab/robot"]
    content = {"digest": DIGEST, "tags": ["ghcr.io/lab/robot:main"], "public": True, "verify": line, "unsigned": ""}
    folder.write("published.json", json.dumps(content))
    text = summary(report.collect(folder, folder.artifact, EVENT))
    assert f"gh attestation verify \\\n  {line[1]} \\\n  {line[2]}\n" in text
    assert "not signed" not in text
    folder.write("published.json", json.dumps({**content, "verify": [], "unsigned": "grant `this`"}))
    text = summary(report.collect(folder, folder.artifact, EVENT))
    assert "It is not signed: grant `this`." in text
    assert "gh attestation" not in text


def test_a_failure_is_told_once(folder: Folder) -> None:
    """What stopped a job in its own folder, and the same among what was fetched of it."""
    kept.fail(folder.artifact, ["on linux/arm64, test: failed"])
    found = report.collect(folder, folder.artifact, EVENT)
    assert found.failures == ("on linux/arm64, test: failed",)


def test_what_cannot_be_read_of_other_jobs_does_not_keep_the_summary_away(folder: Folder, tmp_path: Path) -> None:
    (tmp_path / "reports").mkdir()
    (tmp_path / "reports" / kept.NAME).write_text("{}")
    kept.fail(folder.artifact, ["reports is no report of a job"])
    assert report.collect(folder, tmp_path / "reports", EVENT).failures == ("reports is no report of a job",)


def test_a_run_that_should_have_published_and_did_not_has_failed(folder: Folder) -> None:
    assert report.collect(folder, folder.artifact, EVENT).failures
