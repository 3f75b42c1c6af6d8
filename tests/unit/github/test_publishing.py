"""What a report names must be what the registry holds, of this commit."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path

import pytest

from roslab.errors import RefusedError
from roslab.github.publishing import REVISION, verify
from roslab.github.run import Run
from roslab.pipeline import plan_repository
from roslab.render.outcome import PlatformReport, ProofReport

COMMIT = "1" * 40
INDEX, IMAGE, OTHER = ("sha256:" + letter * 64 for letter in "abc")


@pytest.fixture
def run(tmp_path: Path, examples: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Return a run whose registry, a stand-in of docker, holds one index with one image."""
    (tmp_path / "index").write_text(json.dumps({"manifests": [{"digest": IMAGE}]}))
    config = {"architecture": "amd64", "os": "linux", "config": {"Labels": {REVISION: COMMIT}}}
    (tmp_path / "image").write_text(json.dumps(config))
    tool = tmp_path / "bin/docker"
    tool.parent.mkdir()
    tool.write_text(f'#!/bin/sh\ncase "$*" in *--raw*) cat {tmp_path}/index ;; *) cat {tmp_path}/image ;; esac\n')
    tool.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tool.parent}{os.pathsep}{os.environ['PATH']}")
    plan = replace(plan_repository(examples / "python_filter", folder_name="robot").plan, platforms=("linux/amd64",))
    return Run(
        plan=plan, image="ghcr.io/lab/robot", username="lab", push=True, reason="a push", cache="auto", revision=COMMIT
    )


def reported(run: Run) -> PlatformReport:
    proofs = tuple(
        ProofReport(name=proof.name, command="", passed=True, summary="passed", output="") for proof in run.plan.proofs
    )
    return PlatformReport(
        platform="linux/amd64", digest=IMAGE, source=INDEX, layers=(), proofs=proofs, build_seconds=None
    )


def test_what_the_registry_holds_is_believed(run: Run) -> None:
    verify(run, (reported(run),))
    verify(run, (replace(reported(run), digest=INDEX),))


def test_a_digest_that_the_index_does_not_name_is_not(run: Run) -> None:
    with pytest.raises(RefusedError, match="which holds no such image"):
        verify(run, (replace(reported(run), digest=OTHER),))
    with pytest.raises(RefusedError, match="an image of 1111111111"):
        verify(replace(run, revision="2" * 40), (reported(run),))
