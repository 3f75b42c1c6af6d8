"""What a caller may ask of both doors: a folder of the repository, names of tags, an own Dockerfile's arguments."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from lab import doors
from lab.act import Result, run_workflow
from lab.laboratory import Laboratory

DOCKERFILE = """\
FROM ubuntu:24.04 AS told
ARG WHO=nobody
RUN uname -m >/machine; echo "told by ${WHO}" >/who
FROM told
RUN false
"""
RECIPE = """\
format: 3
kind: cpp
dockerfile: Dockerfile
args: {WHO: "the author, once"}
target: told
tags: {suffix: -arm}
test: cat /who
"""
FILES = {
    "robots/arm/Dockerfile": DOCKERFILE,
    "robots/arm/roslab.yaml": RECIPE,
    "robots/arm/CMakeLists.txt": "project(arm)\n",
}
Door = Callable[..., Path]


def run(lab: Laboratory, caller: Path, repository: str, **event: str) -> Result:
    return run_workflow(lab, caller, "push", doors.payload(repository, **event), env=doors.builder(lab))


@pytest.mark.parametrize("door", [doors.through_action, doors.through_workflow], ids=["action", "workflow"])
def test_a_folder_with_its_own_tags(lab: Laboratory, tmp_path: Path, door: Door) -> None:
    repository = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    inputs = {"registry": lab.registry, "platforms": "linux/amd64", "path": "robots/arm", "cache": "none"}
    ran = run(lab, door(tmp_path, inputs, FILES), repository)
    assert ran.exit_code == 0, ran.log
    assert "told by the author, once" in ran.log
    image = f"{doors.OWNER}/{repository}-robots-arm"
    assert ran.output("image") == f"{lab.registry}/{image}"
    names = {"sha" if name.startswith("sha-") else name for name in doors.tags(image)}
    assert names == {"main-arm", "latest-arm", "sha"}
    assert all(name.endswith("-arm") for name in doors.tags(image))


def test_an_old_tag_on_runners_of_the_callers(lab: Laboratory, tmp_path: Path) -> None:
    """The lab's checkout is at the tag; the event is one of the main branch, whose tags are not touched."""
    repository = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    runners = {"plan": ["ubuntu-24.04"], "linux/amd64": ["ubuntu-24.04"]}
    inputs = {"registry": lab.registry, "platforms": "linux/amd64", "ref": "v1.2.3", "runners": json.dumps(runners)}
    caller = doors.through_workflow(tmp_path, inputs)
    ran = run(lab, caller, repository, ref="refs/tags/v1.2.3")
    assert ran.exit_code == 0, ran.log
    names = {"sha" if name.startswith("sha-") else name for name in doors.tags(f"{doors.OWNER}/{repository}")}
    assert names == {"v1.2.3", "1.2.3", "1.2", "sha"}
