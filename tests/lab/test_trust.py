"""What a repository, a registry's name or another job may try, through both doors: nothing of it reaches the runner."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from lab import doors, registry
from lab.act import RUN_TOKEN, run_workflow
from lab.faulty_registry import Faults, faulty_registry
from lab.kept_artifacts import artifacts
from lab.laboratory import Laboratory

RAN = "print('::error::the repository ran on the runner'); raise SystemExit(1)\n"
PROGRAM = ("scripts/__main__.py", "scripts/environment.py", "scripts/yaml.py", "scripts/roslab/__init__.py")
DOORS = pytest.mark.parametrize("door", [doors.through_action, doors.through_workflow], ids=["action", "image"])


@pytest.fixture
def name(lab: Laboratory) -> str:
    """Return the name of a repository that nothing was pushed to yet, without its owner."""
    return lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]


@DOORS
@pytest.mark.parametrize("what", ["link", "link out", "file", "folder"])
def test_a_repository_at_the_programs_place_changes_nothing(
    lab: Laboratory, tmp_path: Path, name: str, door: type, what: str
) -> None:
    """Its own modules, below ``scripts/`` and where the program is checked out, are neither run nor imported."""
    files = dict.fromkeys(PROGRAM, RAN) | {f"evil/{path}": RAN for path in PROGRAM}
    if what == "file":
        files |= {".repro-action": "a file\n"}
    if what == "folder":
        files |= {f".repro-action/{path}": RAN for path in PROGRAM}
    caller = door(tmp_path / "caller", {"push": "false", "platforms": "linux/amd64"}, files, secret=None)
    outside = tmp_path / "outside"
    outside.mkdir()
    (outside / "kept").touch()
    if what.startswith("link"):
        (caller / ".repro-action").symlink_to("evil" if what == "link" else outside)
    ran = run_workflow(lab, caller, "push", doors.payload(name), env=doors.builder(lab))
    assert ran.exit_code == 0, ran.log
    assert doors.errors(ran) == []
    assert "Built and proved, not published" in ran.summary
    assert list(outside.iterdir()) == [outside / "kept"]


@DOORS
@pytest.mark.parametrize("secret", [None, "GITHUB_TOKEN"])
def test_the_runs_own_token_is_sent_to_no_other_registry(
    lab: Laboratory, tmp_path: Path, name: str, door: type, secret: str | None
) -> None:
    """Neither of itself nor where the caller hands it over: the registry is not even asked."""
    asked = Faults(matches=lambda *_: True, times=10**9)
    with faulty_registry(lab.registry, asked) as address:
        caller = door(tmp_path / "caller", {"registry": address}, secret=secret)
        ran = run_workflow(lab, caller, "push", doors.payload(name), env=doors.builder(lab))
    assert asked.seen == 0
    assert ran.exit_code != 0
    (error,) = doors.errors(ran)
    setting = "token" if door is doors.through_action else "registry-token"
    assert f"refused: {address} needs a password of its own, and `{setting}` holds none" in error
    assert "Main Log in" not in ran.log
    assert RUN_TOKEN not in ran.log
    assert f"{doors.OWNER}/{name}" not in registry.repositories()


def test_a_report_of_another_job_is_not_believed(lab: Laboratory, tmp_path: Path, name: str) -> None:
    """It looks like a later attempt's, and names an image that an older commit left in the same package."""
    given = {"registry": lab.registry, "platforms": "linux/amd64"}
    old = run_workflow(lab, doors.through_workflow(tmp_path / "old", given), "push", doors.payload(name),
                       env=doors.builder(lab), artifacts=tmp_path / "kept")  # fmt: skip
    assert old.exit_code == 0, old.log
    repository = f"{doors.OWNER}/{name}"
    before = doors.tags(repository)
    kept = artifacts(tmp_path / "kept")
    report = next(data for file, data in kept.items() if file.endswith("/report-linux-amd64.json"))
    job = {"platform": "linux/amd64", "attempt": 9, "failures": []}
    caller = doors.through_workflow(
        tmp_path / "new",
        given,
        {"fake/report-linux-amd64.json": report.decode(), "fake/job.json": json.dumps(job), "new": "a new commit"},
    )
    file = caller / ".github/workflows/caller.yml"
    upload = "actions/upload-artifact@043fb46d1a93c77aae656e7c1c64a875d1fc6a0a"
    file.write_text(
        file.read_text().replace("  image:\n", "  image:\n    needs: stranger\n")
        + "  stranger:\n    runs-on: ubuntu-24.04\n    steps:\n"
        + f"      - uses: {doors.CHECKOUT}\n      - uses: {upload}\n        with:\n"
        + f"          name: {old.output('artifact')}-linux-amd64-9\n          path: fake\n"
    )
    ran = run_workflow(lab, caller, "push", doors.payload(name), env=doors.builder(lab))
    assert ran.exit_code != 0
    assert [error for error in doors.errors(ran) if "refused: the report for linux/amd64 names an image of" in error]
    assert "refused: the report for linux/amd64" in ran.summary
    assert doors.tags(repository) == before


def test_the_password_is_gone_when_the_action_is_done(lab: Laboratory, tmp_path: Path, name: str) -> None:
    """Before the job's end, whose own clean-up a job that is killed never reaches; and other jobs never see it."""
    caller = doors.through_action(tmp_path / "caller", {"registry": lab.registry, "platforms": "linux/amd64"})
    file = caller / ".github/workflows/image.yml"
    look = "find $RUNNER_TEMP $HOME -path '*docker*' -name config.json -exec grep -l auth {} +"
    look += r" | xargs -r printf '%s %s\n' LEFT"
    file.write_text(file.read_text() + f"      - run: {json.dumps(look)}\n")
    ran = run_workflow(lab, caller, "push", doors.payload(name), env=doors.builder(lab))
    assert ran.exit_code == 0, ran.log
    assert "Main Log in" in ran.log
    assert "LEFT /" not in ran.log
