"""The starter for several images: of what changed, which folders are built, and that they are."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from lab import doors
from lab.act import Result, run_workflow
from lab.caller import commit, prepare
from lab.command import run
from lab.home import CHECKOUT
from lab.laboratory import Laboratory

STARTER = ".github/workflows/images.yml"
FOLDERS = ("robots/arm", "robots/base")
RECIPE = "format: 3\ndockerfile: Dockerfile\ntest: cat /machine\n"


def write(lab: Laboratory, folder: Path, changed: str) -> Path:
    """Write a repository that uses the starter, for the lab's registry and one distribution; ``changed`` is new."""
    text = (CHECKOUT / "workflows/monorepo.yml").read_text().replace("[humble, jazzy]", "[jazzy]")
    text += f"      registry: {lab.registry}\n      platforms: linux/amd64\n      cache: none\n"
    text += f"    secrets:\n      registry-token: ${{{{ secrets.{doors.SECRET} }}}}\n"
    files = {f"{part}/{name}": content for part in FOLDERS for name, content in doors.FILES.items()}
    files |= {f"{part}/roslab.yaml": RECIPE for part in FOLDERS} | {STARTER: text, "messages/README.md": "x\n"}
    doors.write(folder, files)
    if changed != STARTER:
        doors.write(folder, {changed: "new\n"})
    return folder


def start(
    lab: Laboratory, tmp_path: Path, changed: str, event: str = "push", *, before: str = "", ref: str = "main",
    name: str = "robot", only: str | None = "changed",
) -> Result:  # fmt: skip
    """Run the starter for a commit that adds ``changed``; ``before`` replaces the event's commit before."""
    caller = write(lab, tmp_path / "caller", changed)
    staged = (
        ("rm", "--cached", "--quiet", "--", changed),
        ("commit", "--quiet", "--message", "before"),
        ("add", "--force", "--", changed),
    )
    payload = doors.payload(name, ref=f"refs/tags/{ref}" if ref.startswith("v") else f"refs/heads/{ref}")
    place = prepare(caller, tmp_path / "once", payload, staged=staged)
    last = run(["git", "-C", place, "rev-parse", "HEAD^"]).strip()
    assert commit(place) != last
    if event == "push":
        payload["before"] = before or last
    if event == "pull_request":
        payload = doors.payload(name, head=f"{doors.OWNER}/{name}")
        payload["pull_request"]["base"]["sha"] = last
    return run_workflow(
        lab, caller, event, payload, env=doors.builder(lab), staged=staged, jobs=[only] if only else None,
        workflow=STARTER,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("changed", "event", "found"),
    [
        ("robots/arm/new.txt", "push", ["robots/arm"]),
        ("robots/base/new.txt", "pull_request", ["robots/base"]),
        ("messages/new.txt", "push", ["robots/arm", "robots/base"]),
        (STARTER, "push", ["robots/arm", "robots/base"]),
        ("README.md", "push", []),
        ("README.md", "workflow_dispatch", ["robots/arm", "robots/base"]),
    ],
)
def test_what_changed(lab: Laboratory, tmp_path: Path, changed: str, event: str, found: list[str]) -> None:
    ran = start(lab, tmp_path, changed, event)
    assert ran.exit_code == 0, ran.log
    assert json.loads(ran.output("folders")) == found


def test_everything_of_a_git_tag(lab: Laboratory, tmp_path: Path) -> None:
    ran = start(lab, tmp_path, "README.md", ref="v1.2.3")
    assert json.loads(ran.output("folders")) == list(FOLDERS)


@pytest.mark.parametrize("before", ["0" * 40, "1" * 40])
def test_everything_where_the_commit_before_is_not_there(lab: Laboratory, tmp_path: Path, before: str) -> None:
    ran = start(lab, tmp_path, "README.md", before=before)
    assert ran.exit_code == 0, ran.log
    assert json.loads(ran.output("folders")) == list(FOLDERS)


def test_only_the_image_of_the_changed_folder_is_built(lab: Laboratory, tmp_path: Path) -> None:
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    ran = start(lab, tmp_path, "robots/arm/new.txt", name=name, only=None)
    assert ran.exit_code == 0, ran.log
    tags = doors.tags(f"{doors.OWNER}/{name}-robots-arm")
    assert {"sha" if tag.startswith("sha-") else tag for tag in tags} == {"main-jazzy", "latest-jazzy", "sha"}
    assert "robots-base" not in ran.log
