"""The small door under act: what an event leaves in the registry, and what a failure leaves alone."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import pytest

from lab import doors, registry
from lab.act import Result, run_workflow
from lab.faulty_registry import Fault, Faults, faulty_registry
from lab.laboratory import Laboratory

NATIVE = {"platforms": "linux/amd64"}
"""Where a second platform would be the same again."""


@pytest.fixture
def repository(lab: Laboratory) -> str:
    """Return the name of a repository that nothing was pushed to yet: OWNER/NAME."""
    return lab.fresh_repository(f"{doors.OWNER}/robot").partition("/")[2]


def run(
    lab: Laboratory, caller: Path, repository: str, event: str = "push", *, token: str | None = None,
    env: Mapping[str, str] | None = None, **event_of: str,
) -> Result:  # fmt: skip
    payload = doors.payload(repository.partition("/")[2], **event_of)
    secrets = {} if token is None else {"REGISTRY_PASSWORD": token}
    return run_workflow(lab, caller, event, payload, env={**doors.builder(lab), **(env or {})}, secrets=secrets)


def test_a_push_leaves_its_tags_on_one_proved_index(lab: Laboratory, tmp_path: Path, repository: str) -> None:
    caller = doors.through_action(tmp_path, {"registry": lab.registry})
    ran = run(lab, caller, repository, env={"ROSLAB_PYTHON_CACHE": ""})  # on a runner that keeps nothing
    assert ran.exit_code == 0, ran.log
    found = doors.tags(repository)
    commit = next(name for name in found if name.startswith("sha-"))
    assert set(found) == {"main", "latest", commit}
    assert set(found.values()) == {ran.output("digest")}
    assert set(ran.output("tags").split()) == {f"{lab.registry}/{repository}:{name}" for name in found}
    assert ran.output("image") == f"{lab.registry}/{repository}"
    assert json.loads(ran.output("plan"))["name"] == repository.partition("/")[2]
    index, _ = registry.manifest(f"{repository}:main")
    platforms = {entry["platform"]["architecture"] for entry in index["manifests"]}
    assert platforms - {"unknown"} == {"amd64", "arm64"}
    # The proof ran on both machines, after the push and before the tags
    prove, tag = ran.log.index("Prove the image"), ran.log.index("Put the proved image")
    assert "x86_64" in ran.log[prove:tag]
    assert "aarch64" in ran.log[prove:tag]
    assert f"Published as `{lab.registry}/{repository}:main`" in ran.summary
    assert ran.output("digest") in ran.summary

    said = [json.loads(data) for data in doors.blobs(lab, f"{lab.registry}/{repository}:main") if data[:1] == b"{"]
    labels = next(entry["config"]["Labels"] for entry in said if "Labels" in entry.get("config", {}))
    assert labels["org.opencontainers.image.created"] == "2026-01-01T00:00:00Z"
    assert labels["org.opencontainers.image.source"] == f"https://github.com/{repository}"
    # The password is in nothing that was published, and not in the log
    assert lab.password not in ran.log
    assert lab.password not in ran.summary
    assert doors.showing(lab, f"{lab.registry}/{repository}:main", "org.opencontainers.image.created")
    assert doors.showing(lab, f"{lab.registry}/{repository}:main", lab.password) == []


@pytest.mark.parametrize("head", ["stranger/robot", "own"])
def test_a_pull_request_builds_and_proves_and_publishes_nothing(
    lab: Laboratory, tmp_path: Path, repository: str, head: str
) -> None:
    caller = doors.through_action(tmp_path, {"registry": lab.registry, "push": "true"})
    ran = run(lab, caller, repository, "pull_request", head=repository if head == "own" else head, token="")
    assert ran.exit_code == 0, ran.log
    assert registry.tags(repository) == ()
    assert repository not in registry.repositories()
    assert "Main Log in" not in ran.log
    assert "Main Move the tags" not in ran.log
    assert "::warning::`push: true` is ignored" in ran.log
    assert "x86_64" in ran.log
    assert "aarch64" in ran.log
    assert ran.output("digest") == ""
    assert "Built and proved, not published" in ran.summary


def test_a_strangers_code_with_our_rights_is_refused(lab: Laboratory, tmp_path: Path, repository: str) -> None:
    caller = doors.through_action(tmp_path, {"registry": lab.registry})
    ran = run(lab, caller, repository, "pull_request_target", head="stranger/robot")
    assert ran.exit_code != 0
    assert "exit status 4" in ran.log or "exitcode '4'" in ran.log
    assert [error for error in doors.errors(ran) if "refused: pull_request_target" in error]
    assert "Main Build" not in ran.log
    assert "Nothing was built" in ran.summary


def test_a_failed_test_leaves_every_tag_where_it_was(lab: Laboratory, tmp_path: Path, repository: str) -> None:
    good = doors.through_action(tmp_path / "good", {"registry": lab.registry})
    assert run(lab, good, repository).exit_code == 0
    before = doors.tags(repository)
    test = "echo told by the test; test $(uname -m) = x86_64"
    bad = doors.through_action(tmp_path / "bad", {"registry": lab.registry, "test": test}, {"new": "a new commit"})
    ran = run(lab, bad, repository)
    assert ran.exit_code != 0
    assert doors.tags(repository) == before
    assert ran.output("digest") == ""
    (error,) = doors.errors(ran)
    assert error.startswith("on linux/arm64, the repository's test: failed with exit code 1")
    assert "told by the test" in ran.summary
    assert "No tag was made or moved." in ran.summary


def test_a_failed_build_says_why(lab: Laboratory, tmp_path: Path, repository: str) -> None:
    caller = doors.through_action(
        tmp_path, {"registry": lab.registry}, {"Dockerfile": "FROM ubuntu:24.04\nRUN echo told; exit 7\n"}
    )
    ran = run(lab, caller, repository)
    assert ran.exit_code != 0
    assert registry.tags(repository) == ()
    assert [error for error in doors.errors(ran) if "the build failed" in error and "exit code: 7" in error]
    assert "exit code: 7" in ran.summary


def test_a_wrong_password_fails_with_one_line(lab: Laboratory, tmp_path: Path, repository: str) -> None:
    caller = doors.through_action(tmp_path, {"registry": lab.registry})
    ran = run(lab, caller, repository, token="not-the-password")
    assert ran.exit_code != 0
    (error,) = doors.errors(ran)
    assert f"{lab.registry} refuses the username or the token" in error
    assert "Main Build" not in ran.log
    assert "not-the-password" not in ran.log


def test_bad_inputs_are_told_at_once(lab: Laboratory, tmp_path: Path, repository: str) -> None:
    wrong = {"registry": lab.registry, "push": "maybe", "platforms": "linux/amd46", "image": "a b"}
    caller = doors.through_action(tmp_path, wrong, {"roslab.yaml": "format: 3\nbase: {ros: jazzi}\n"})
    ran = run(lab, caller, repository)
    assert ran.exit_code != 0
    said = doors.errors(ran)
    assert [error for error in said if "input push" in error]
    assert [error for error in said if "input platforms" in error and "linux/amd64" in error]


def is_tag(method: str, path: str) -> bool:
    return method == "PUT" and "/manifests/" in path and "sha256:" not in path


def is_push(method: str, path: str) -> bool:
    return method in ("PUT", "PATCH")


@pytest.mark.parametrize("what", [is_tag, is_push])
def test_a_registry_that_recovers(lab: Laboratory, tmp_path: Path, repository: str, what: Fault) -> None:
    faults = Faults(matches=what, times=2)
    with faulty_registry(lab.registry, faults) as address:
        caller = doors.through_action(tmp_path, {"registry": address, **NATIVE})
        ran = run(lab, caller, repository)
    assert faults.seen == 2
    assert ran.exit_code == 0, ran.log
    assert {"main", "latest"} < set(doors.tags(repository))


@pytest.mark.parametrize("what", [is_tag, is_push])
def test_a_registry_that_never_recovers(lab: Laboratory, tmp_path: Path, repository: str, what: Fault) -> None:
    good = doors.through_action(tmp_path / "good", {"registry": lab.registry, **NATIVE})
    assert run(lab, good, repository).exit_code == 0
    before = doors.tags(repository)
    with faulty_registry(lab.registry, Faults(matches=what, times=10**9)) as address:
        caller = doors.through_action(tmp_path / "bad", {"registry": address, **NATIVE}, {"new": "a new commit"})
        ran = run(lab, caller, repository)
    assert ran.exit_code != 0
    assert doors.tags(repository) == before
    assert [error for error in doors.errors(ran) if "503" in error], doors.errors(ran)
    assert "No tag was made or moved." in ran.summary
