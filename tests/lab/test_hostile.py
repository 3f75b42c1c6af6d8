"""One tree written to attack, through both doors: nothing outside a container is touched, and nothing is forged."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from hostile_tree import BRANCH, MARK, SUBJECT, commands, foreign, gitlinks, listing, write
from lab import doors
from lab.act import Result, run_workflow
from lab.home import CHECKOUT
from lab.laboratory import Laboratory

BUILD = "build"
"""The one step whose log a Dockerfile writes: a runner reads its commands, and nothing that follows believes them."""
Door = Callable[..., Path]
OURS = {"error", "warning", "notice", "group", "endgroup"}
KNOWN = re.compile(
    r".*/(?:tmp/(?:roslab-|docker-config\b|docker-actions-toolkit-)|act/(?:actions|workflow)\b|workflow/|"
    r"hostexecutor/(?:\.git/|sub\b)|\.rustup\b)",
    re.DOTALL,
)
"""What act, the builder's client and the program itself write in a job, the submodules' empty folders
included; pip asks for the version of a Rust compiler."""


def through(lab: Laboratory, tmp_path: Path, door: Door, config: str) -> tuple[Result, str, list[dict[str, Any]], Path]:
    """Run the tree through a door; return what came of it, the repository's name, act's lines and its place."""
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    inputs = {"registry": lab.registry, "platforms": "linux/amd64", "config": config, "cache": "none"}
    caller = door(tmp_path / "caller", inputs)
    for path in ("Dockerfile", "roslab.yaml", "CMakeLists.txt", "yaml.py", "roslab/__init__.py"):
        (caller / path).unlink()
    (caller / "roslab").rmdir()
    write(caller, tmp_path / "outside")
    if door is doors.through_action:
        # A job of the caller's own: what is beside the checkout is listed before and after
        file = caller / ".github/workflows/image.yml"
        look = f"{sys.executable} -I {CHECKOUT}/tests/hostile_tree.py {tmp_path}/seen $HOME $(dirname $RUNNER_TEMP)"
        text = file.read_text().replace("      - id: image\n", f"      - run: {look}\n      - id: image\n")
        file.write_text(f"{text}      - run: {look}\n        if: always()\n")
    lines: list[dict[str, Any]] = []
    outside = listing(tmp_path / "outside")
    event = doors.payload(name, ref=f"refs/heads/{BRANCH}")
    place = tmp_path / "place"
    ran = run_workflow(
        lab, caller, "push", event, env=doors.builder(lab), subject=SUBJECT, staged=gitlinks(), place=place,
        raw=lambda line: lines.append(json.loads(line)) if line.startswith("{") else None,
    )  # fmt: skip
    assert listing(tmp_path / "outside") == outside, "something outside the repository has changed"
    return ran, name, lines, place


@pytest.mark.parametrize(
    ("door", "config"),
    [
        (doors.through_action, "roslab.yaml"),
        (doors.through_workflow, "roslab.yaml"),
        (doors.through_action, "broken.yaml"),
        (doors.through_workflow, "fails.yaml"),
    ],
    ids=["action", "workflow", "action-build-fails", "workflow-proof-fails"],
)
def test_a_tree_that_attacks(lab: Laboratory, tmp_path: Path, door: Door, config: str) -> None:
    ran, name, lines, place = through(lab, tmp_path, door, config)
    works = config == "roslab.yaml"
    (tmp_path / "summary.md").write_text(ran.summary)
    (tmp_path / "log.json").write_text(json.dumps(lines))
    assert (ran.exit_code == 0) == works, ran.log
    # What it says is nowhere taken for a command but in the step that runs its Dockerfile
    logs: dict[tuple[str, ...], str] = {}
    for line in lines:
        if said := line.get("raw") or (line.get("raw_output") and line["msg"]):
            step = (str(line["job"]), *line["stepID"])
            logs[step] = logs.get(step, "") + str(said)
    assert BUILD in {step[-1] for step in logs}, "the log names no steps"
    forged = {
        (step, *said)
        for step, log in logs.items()
        for said in commands(log)
        if said[1].startswith(MARK) or said[0] not in OURS
    }
    assert {(step[-1], said) for step, *said in forged if step[-1] != BUILD} == set()
    assert forged, "its Dockerfile says nothing"
    assert [value for values in ran.outputs.values() for value in values.values() if value.startswith(MARK)] == []
    # The summary is text
    assert f"### {'✅ Published as' if works else '❌ Failed'}" in ran.summary
    assert MARK in ran.summary
    assert foreign(ran.summary) == []
    # What is published is what was asked for
    tags = doors.tags(f"{doors.OWNER}/{name}")
    assert len(tags) == (2 if works else 0), tags
    assert all(re.fullmatch(r"sha-[0-9a-f]{7}|x-0A-img-src-[\w.-]+", tag) for tag in tags)
    changed = [line.partition("CHANGED")[2] for line in ran.log.splitlines() if "CHANGED " in line]
    assert [path for path in changed if not KNOWN.match(path)] == []
    assert changed or door is doors.through_workflow
    assert [path for path in listing(place) if Path(path).name in {"ran", MARK}] == []
