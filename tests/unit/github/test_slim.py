"""The slim image of a run: what it says of itself, which tags it gets, and that it withholds no other's."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import TagParts
from roslab.errors import RefusedError
from roslab.github import slim, tags
from roslab.github.publishing import verify
from roslab.github.run import Folder, Run
from roslab.pipeline import plan_repository
from roslab.plan.ladder import Ladder, Rung
from roslab.render.outcome import PlatformReport, ProofReport, Report, SlimReport
from roslab.render.sizes import LayerSize
from roslab.render.slim import section

DIGEST = "sha256:" + "a" * 64
PROOF = ProofReport(name="test", command="true", passed=True, summary="passed", output="")
HELD = SlimReport(
    digest=DIGEST,
    source=DIGEST,
    size=40_000_000,
    proofs=(PROOF,),
    ladder=Ladder(rungs=(Rung(number=0, state="held", said="it installs"),)),
)
PLATFORMS = ("linux/amd64", "linux/arm64")


def run_of(examples: Path) -> Run:
    plan = replace(plan_repository(examples / "no_config", folder_name="robot").plan, platforms=PLATFORMS, slim=True)
    return Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=True, reason="a push", cache="auto")


def reports(*found: SlimReport | None) -> tuple[PlatformReport, ...]:
    whole = PlatformReport(
        platform="", digest=DIGEST, source=DIGEST, proofs=(PROOF,), build_seconds=1.0,
        layers=(LayerSize(size=100_000_000, text="RUN apt-get install", base=False),),
    )  # fmt: skip
    return tuple(replace(whole, platform=name, slim=each) for name, each in zip(PLATFORMS, found, strict=True))


def test_it_needs_every_platform(examples: Path) -> None:
    run = run_of(examples)
    assert slim.complete(run, reports(HELD, HELD))
    assert not slim.complete(run, reports(HELD, None))
    assert not slim.complete(run, reports(HELD, replace(HELD, failure="on linux/arm64, test: exit code 1")))
    assert not slim.complete(run, reports(HELD, replace(HELD, source="")))
    assert not slim.complete(replace(run, plan=replace(run.plan, slim=False)), reports(HELD, HELD))


def test_its_tags_end_in_slim_however_long_they_are() -> None:
    parts = tags.of_slim(TagParts(prefix="v-", suffix="-humble"))
    assert tags.dressed("ghcr.io/lab/robot:main", parts) == "ghcr.io/lab/robot:v-main-humble-slim"
    name = tags.dressed(f"ghcr.io/lab/robot:{'x' * 128}", parts).rpartition(":")[2]
    assert len(name) == 128
    assert name.endswith("-humble-slim")


def test_the_report_travels_with_the_platforms(tmp_path: Path) -> None:
    folder = Folder(path=tmp_path)
    report = reports(HELD, None)[0]
    folder.write_report(report)
    assert folder.report("linux/amd64") == report
    folder.write_report(replace(report, slim=replace(HELD, digest="$(true)")))
    with pytest.raises(ValueError, match="is no digest"):
        folder.report("linux/amd64")


def told(examples: Path, platforms: tuple[PlatformReport, ...], *names: str, published: bool = True) -> str:
    run = run_of(examples)
    found = Report(
        plan=run.plan, image=run.image, published=published, reason="", platforms=platforms,
        slim=tuple(f"{run.image}:{name}" for name in names),
    )  # fmt: skip
    return section(found)


def test_the_summary_has_both_sizes(examples: Path) -> None:
    text = told(examples, reports(HELD, HELD), "sha-1234567-slim", "main-slim")
    assert "Published too: `sha-1234567-slim`, `main-slim`." in text
    assert "`linux/amd64`: ✅ rung 0, installs; 40.0 MB in the place of 100.0 MB" in text


def test_the_summary_says_why_there_is_none(examples: Path) -> None:
    failed = SlimReport(failure="on linux/arm64, test: `g++` is <b>gone</b>")
    text = told(examples, reports(HELD, failed))
    assert "It got no tag: the whole image is published without it." in text
    assert "`linux/arm64`: ❌ on linux/arm64, test:" in text
    assert "<b>" not in text
    assert "Built and proved, not published." in told(examples, reports(HELD, HELD), published=False)
    assert told(examples, reports(None, None)) == ""


def test_what_it_names_must_be_what_the_registry_holds(
    examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """docker is a stand-in whose registry holds one image, of another commit."""
    tool = tmp_path / "docker"
    tool.write_text('#!/bin/sh\necho \'{"architecture": "amd64", "os": "linux", "manifests": []}\'\n')
    tool.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    with pytest.raises(RefusedError, match="the slim image's report for linux/amd64"):
        verify(replace(run_of(examples), revision="1" * 40), reports(HELD, None)[:1])
