"""What is decided in one job arrives whole in the next."""

from __future__ import annotations

import dataclasses
import json
import os
from pathlib import Path

import pytest

from roslab.decide.decision import Reason
from roslab.errors import ConfigurationError
from roslab.github.run import PORTABLE, Folder, Run, from_line, reports, to_json
from roslab.pipeline import plan_repository
from roslab.render.sizes import LayerSize
from roslab.render.summary import PlatformReport, ProofReport

NAMES = (
    "ros1_talker",
    "ros2_filter",
    "ros2_talker",
    "python_filter",
    "cuda_saxpy",
    "own_dockerfile",
    "monorepo",
    "no_config",
)


def run(examples: Path, name: str = "ros2_filter") -> Run:
    plan = plan_repository(examples / name).plan
    return Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=True, reason="why", cache="auto")


@pytest.mark.parametrize("name", NAMES)
def test_there_and_back(examples: Path, name: str) -> None:
    decided = run(examples, name)
    line = to_json(decided)
    assert "\n" not in line
    assert from_line(line) == decided


def test_a_large_plan_still_fits_into_an_environment_variable(examples: Path) -> None:
    decided = run(examples)
    reason = Reason(question="dependencies", answer="x" * 100, reason="y" * 400, decisive=True)
    large = dataclasses.replace(decided, plan=dataclasses.replace(decided.plan, reasons=(reason,) * 2000))
    line = to_json(large)
    assert len(line) <= PORTABLE
    assert from_line(line).plan.base_image == decided.plan.base_image


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"plan": {}}', '{"plan": 3, "image": 4}', "null"])
def test_something_else_is_refused(text: str) -> None:
    with pytest.raises(ConfigurationError):
        from_line(text)


def report(platform: str, digest: str = "sha256:0") -> PlatformReport:
    proof = ProofReport(name="a", command="b", passed=True, summary="c", output="d")
    layer = LayerSize(size=1, text="RUN x", base=False)
    return PlatformReport(
        platform=platform, digest=digest, source="", layers=(layer,), proofs=(proof,), build_seconds=1.5
    )


def test_reports_of_several_jobs(tmp_path: Path) -> None:
    for number, platform in enumerate(("linux/amd64", "linux/arm64")):
        folder = Folder(path=tmp_path / str(number))
        folder.path.mkdir()
        folder.write_report(report(platform))
    assert set(reports(tmp_path)) == {report("linux/amd64"), report("linux/arm64")}


def test_of_two_reports_for_a_platform_the_newer_counts(tmp_path: Path) -> None:
    for number in (0, 1):
        folder = Folder(path=tmp_path / str(number))
        folder.path.mkdir()
        folder.write_report(report("linux/amd64", f"sha256:{number}"))
        os.utime(folder.artifact / "report-linux-amd64.json", (100 - number, 100 - number))
    assert reports(tmp_path) == (report("linux/amd64", "sha256:0"),)


def test_no_report(tmp_path: Path) -> None:
    (tmp_path / "report-linux-amd64.json").write_text(json.dumps({"platform": 1}))
    with pytest.raises(ConfigurationError, match="is no report"):
        reports(tmp_path)
