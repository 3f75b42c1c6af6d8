"""The lock of a published image as a pull request: opened once, written anew, and nobody's commits are lost."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from lab.api_stub import api_stub
from roslab.github import offering
from roslab.github.event import Event
from roslab.github.run import Folder, Run, to_line
from roslab.pipeline import plan_repository
from roslab.plan.lock import from_text, to_text
from roslab.plan.locked import Lock, Machine, Package

EVENT = Event(
    name="push", repository="lab/robot", ref="refs/heads/main", sha="c" * 40, default_branch="main", proposed=False,
    run="9",
)  # fmt: skip
DIGEST = "sha256:" + "b" * 64
Known = dict[str, Any]


def lock(version: str) -> str:
    apt = Package(name="robot", version=version, architecture="all", source="robot", origin="", step="packages")
    machine = Machine(platform="linux/amd64", apt=(apt,), python=(), conda=())
    return to_text(
        Lock(
            base="ubuntu:24.04", digest=DIGEST, python="venv", rosdistro=None, tools=(), sources=(), machines=(machine,)
        )
    )


@pytest.fixture
def folder(tmp_path: Path, examples: Path) -> Folder:
    folder = Folder.new({"RUNNER_TEMP": str(tmp_path)})
    plan = plan_repository(examples / "python_filter").plan
    run = Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=True, reason="why", cache="auto", lock=True)
    folder.write("run", to_line(run))
    folder.write("roslab.lock", lock("1.0"))
    return folder


@pytest.fixture
def known() -> Known:
    return {"heads": {"main": EVENT.sha}, "proposed": [], "contents": {}}


@pytest.fixture
def environment(known: Known) -> Iterator[dict[str, str]]:
    with api_stub(known) as address:
        yield {"GITHUB_API_URL": address, "ROSLAB_GITHUB_TOKEN": "t"}


def offer(folder: Folder, environment: dict[str, str], event: Event = EVENT, **changes: Any) -> None:
    offering.offer(folder, replace(folder.run, **changes), event, DIGEST, environment)


def test_a_first_lock_is_offered_once(folder: Folder, known: Known, environment: dict[str, str]) -> None:
    offer(folder, environment)
    assert known["heads"]["roslab/lock"] == EVENT.sha
    assert known["contents"] == {"roslab.lock": lock("1.0")}
    (pull,) = known["proposed"]
    assert (pull["base"], pull["head"]) == ("main", {"ref": "roslab/lock"})
    assert "robot on linux/amd64: new, 1.0" in pull["body"]
    assert f"ghcr.io/lab/robot@{DIGEST}" in pull["body"]
    assert "actions/runs/9" in pull["body"]
    folder.write("roslab.lock", lock("2.0"))
    offer(folder, environment)
    (pull,) = known["proposed"]
    assert known["contents"] == {"roslab.lock": lock("2.0")}
    assert "new, 2.0" in pull["body"]


def test_what_the_branch_has_is_not_offered(
    folder: Folder, known: Known, environment: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    plan = replace(folder.run.plan, lock=from_text(lock("1.0")))
    offer(folder, environment, plan=plan)
    assert known["proposed"] == []
    assert "holds what was published" in capsys.readouterr().err
    folder.write("roslab.lock", lock("2.0"))
    offer(folder, environment, plan=plan)
    assert "robot on linux/amd64: 1.0, then 2.0" in known["proposed"][0]["body"]
    assert "1 of 1 packages" in known["proposed"][0]["body"]


def test_the_lock_lies_beside_its_configuration(folder: Folder, known: Known, environment: dict[str, str]) -> None:
    offer(folder, environment, path="robots/arm", config="docker/roslab.yaml")
    assert list(known["contents"]) == ["robots/arm/docker/roslab.lock"]
    assert known["proposed"][0]["head"] == {"ref": "roslab/lock-robots-arm-docker"}


def test_somebody_elses_commits_stay(
    folder: Folder, known: Known, environment: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    known["heads"]["roslab/lock"] = "d" * 40
    known["authors"] = {"d" * 40: "somebody"}
    offer(folder, environment)
    assert known["contents"] == {}
    assert "somebody else committed to the branch roslab/lock" in capsys.readouterr().err


def test_without_the_right_the_run_says_which(
    folder: Folder, known: Known, environment: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    del known["proposed"]
    offer(folder, environment)
    assert "contents: write, pull-requests: write" in capsys.readouterr().err


@pytest.mark.parametrize("ref", ["refs/heads/other", "refs/tags/v1"])
def test_only_the_default_branch_gets_one(folder: Folder, known: Known, environment: dict[str, str], ref: str) -> None:
    offer(folder, environment, replace(EVENT, ref=ref))
    assert known["proposed"] == []
    folder.write("roslab.lock", "")
    offer(folder, environment)
    assert known["proposed"] == []
