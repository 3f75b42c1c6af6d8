"""The wide door under act, its files unchanged: which jobs run for an event, and what they leave in the registry."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from lab import doors, registry
from lab.act import Result, run_workflow
from lab.faulty_registry import Faults, faulty_registry
from lab.laboratory import Laboratory


@pytest.fixture
def repository(lab: Laboratory) -> str:
    """Return the name of a repository that nothing was pushed to yet: OWNER/NAME."""
    return lab.fresh_repository(f"{doors.OWNER}/robot").partition("/")[2]


def run(
    lab: Laboratory, caller: Path, repository: str, event: str = "push", *, token: str | None = None, **event_of: str
) -> Result:
    payload = doors.payload(repository.partition("/")[2], **event_of)
    if event == "schedule":
        payload["schedule"] = "17 4 * * 1"
    secrets = {} if token is None else {"REGISTRY_PASSWORD": token}
    return run_workflow(lab, caller, event, payload, env=doors.builder(lab), secrets=secrets)


def named(found: dict[str, str]) -> set[str]:
    """Return the names of tags, a commit's own as ``sha``."""
    return {"sha" if name.startswith("sha-") else name for name in found}


def proved(ran: Result) -> set[str]:
    """Return the machines on which the proof of these tests ran: it prints the machine that built the image."""
    return {name for name in ("x86_64", "aarch64") if name in ran.log}


@pytest.mark.parametrize(
    ("event", "ref", "expected"),
    [
        ("push", "refs/heads/main", {"main", "latest", "sha"}),
        ("push", "refs/heads/fix/it", {"fix-it", "sha"}),
        ("push", "refs/tags/v1.2.3", {"v1.2.3", "1.2.3", "1.2", "sha"}),
        ("schedule", "refs/heads/main", {"nightly", "main", "latest", "sha"}),
        ("workflow_dispatch", "refs/heads/main", {"main", "latest", "sha"}),
    ],
)
def test_what_an_event_publishes(  # noqa: PLR0917 - fixtures
    lab: Laboratory, tmp_path: Path, repository: str, event: str, ref: str, expected: set[str]
) -> None:
    caller = doors.through_workflow(tmp_path, {"registry": lab.registry})
    ran = run(lab, caller, repository, event, ref=ref)
    assert ran.exit_code == 0, ran.log
    found = doors.tags(repository)
    assert named(found) == expected
    assert set(found.values()) == {ran.output("digest")}
    index, _ = registry.manifest(f"{repository}:{next(iter(found))}")
    assert {entry["platform"]["architecture"] for entry in index["manifests"]} - {"unknown"} == {"amd64", "arm64"}
    assert proved(ran) == {"x86_64", "aarch64"}
    assert set(ran.jobs.values()) == {"success"}
    assert len(ran.jobs) >= 4  # plan, a build for each platform, publish
    assert json.loads(ran.output("plan"))["platforms"] == ["linux/amd64", "linux/arm64"]
    assert "Published as" in ran.summary
    assert "linux/arm64" in ran.summary
    assert lab.password not in ran.log + ran.summary
    for name in found:
        assert doors.showing(lab, f"{lab.registry}/{repository}:{name}", lab.password) == []


@pytest.mark.parametrize("head", ["stranger/robot", "own"])
def test_a_pull_request_publishes_nothing(lab: Laboratory, tmp_path: Path, repository: str, head: str) -> None:
    caller = doors.through_workflow(tmp_path, {"registry": lab.registry, "push": "true"})
    ran = run(lab, caller, repository, "pull_request", head=repository if head == "own" else head, token="")
    assert ran.exit_code == 0, ran.log
    assert repository not in registry.repositories()
    assert "Main Log in" not in ran.log
    assert "Main Move the tags" not in ran.log
    assert proved(ran) == {"x86_64", "aarch64"}
    assert "Built and proved, not published" in ran.summary


@pytest.mark.parametrize(
    ("door", "files", "inputs"),
    [
        ("ros2", {}, {"distro": "jazzy"}),
        ("ros1", {}, {"distro": "noetic", "build-tool": "catkin_make"}),
        ("python", {"main.py": "print('hello')\n"}, {"python": "3.11"}),
        ("cuda", {"CMakeLists.txt": "project(robot LANGUAGES CXX CUDA)\n"}, {"cuda": "12.4"}),
    ],
)
def test_each_kind_has_its_door(  # noqa: PLR0917 - fixtures
    lab: Laboratory, tmp_path: Path, repository: str, door: str, files: dict[str, str], inputs: dict[str, str]
) -> None:
    recipe = "format: 3\ndockerfile: Dockerfile\ntest: cat /machine\n"  # the kind comes from the door
    given = {"registry": lab.registry, **inputs}
    caller = doors.through_workflow(tmp_path, given, {**files, "roslab.yaml": recipe}, door=door)
    ran = run(lab, caller, repository)
    assert ran.exit_code == 0, ran.log
    plan = json.loads(ran.output("plan"))
    assert plan["kind"] == door
    if "distro" in inputs:
        assert plan["ros_distro"] == inputs["distro"]
    assert {"main", "latest"} < set(doors.tags(repository))


@pytest.mark.parametrize(
    ("inputs", "files", "said"),
    [
        ({"test": "test $(uname -m) = x86_64"}, {}, "on linux/arm64, the repository's test: failed with exit code 1"),
        ({}, {"Dockerfile": "FROM ubuntu:24.04\nRUN test $(uname -m) = x86_64\n"}, "the build failed"),
    ],
    ids=["proof", "build"],
)
def test_one_platform_that_fails_keeps_every_tag(  # noqa: PLR0917 - fixtures
    lab: Laboratory, tmp_path: Path, repository: str, inputs: dict[str, str], files: dict[str, str], said: str
) -> None:
    good = doors.through_workflow(tmp_path / "good", {"registry": lab.registry})
    assert run(lab, good, repository).exit_code == 0
    before = doors.tags(repository)
    given = {"registry": lab.registry, **inputs}
    bad = doors.through_workflow(tmp_path / "bad", given, {"new": "a new commit", "roslab.yaml": doors.RECIPE, **files})
    ran = run(lab, bad, repository)
    assert ran.exit_code != 0
    assert doors.tags(repository) == before
    assert [error for error in doors.errors(ran) if said in error], doors.errors(ran)
    assert "Main Move the tags" not in ran.log
    assert said in ran.summary
    assert "No tag was made or moved." in ran.summary


def is_push(method: str, path: str) -> bool:
    return method in ("PUT", "PATCH")


@pytest.mark.parametrize("times", [2, 10**9], ids=["twice", "for ever"])
def test_a_registrys_bad_day(lab: Laboratory, tmp_path: Path, repository: str, times: int) -> None:
    with faulty_registry(lab.registry, Faults(matches=is_push, times=times)) as address:
        caller = doors.through_workflow(tmp_path, {"registry": address})
        ran = run(lab, caller, repository)
    recovered = times == 2
    assert (ran.exit_code == 0) == recovered, ran.log
    assert bool(doors.tags(repository)) == recovered
    if not recovered:
        assert [error for error in doors.errors(ran) if "503" in error], doors.errors(ran)
