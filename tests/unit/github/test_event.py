"""Which runs publish, and which are refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from roslab.errors import ConfigurationError, RefusedError
from roslab.github import event

OWN: dict[str, Any] = {"full_name": "lab/robot", "default_branch": "main", "private": False}


def read(tmp_path: Path, name: str, payload: dict[str, Any], **more: str) -> event.Event:
    file = tmp_path / "event.json"
    file.write_text(json.dumps({"repository": OWN, **payload}))
    environment = {
        "GITHUB_EVENT_NAME": name,
        "GITHUB_EVENT_PATH": str(file),
        "GITHUB_REPOSITORY": "lab/robot",
        "GITHUB_REF": "refs/heads/main",
        "GITHUB_SHA": "0" * 40,
    }
    return event.read({**environment, **more})


def pull_request(head: str | None) -> dict[str, Any]:
    return {"pull_request": {"head": {"repo": {"full_name": head} if head else None}, "base": {"ref": "main"}}}


@pytest.mark.parametrize(
    "name", ["push", "schedule", "workflow_dispatch", "repository_dispatch", "release", "create", "workflow_run"]
)
def test_own_code_is_published(tmp_path: Path, name: str) -> None:
    payload = {"workflow_run": {"event": "push", "head_repository": {"full_name": "lab/robot"}}}
    found = read(tmp_path, name, payload if name == "workflow_run" else {})
    assert event.publication(found, "auto").push
    assert event.publication(found, "true").push
    assert not event.publication(found, "false").push


@pytest.mark.parametrize("head", ["lab/robot", "stranger/robot", None])
@pytest.mark.parametrize("wish", ["auto", "true", "false"])
def test_a_pull_request_is_never_published(tmp_path: Path, head: str | None, wish: event.Push) -> None:
    found = event.publication(read(tmp_path, "pull_request", pull_request(head)), wish)
    assert not found.push
    assert (found.warning is not None) == (wish == "true")
    assert ("fork" in found.reason) == (head == "stranger/robot")


@pytest.mark.parametrize(
    ("name", "head", "wish", "actor", "push"),
    [
        ("pull_request", "lab/robot", "auto", "lab", True),
        ("pull_request", "Lab/Robot", "true", "lab", True),
        ("pull_request", "lab/robot", "false", "lab", False),
        ("pull_request", "lab/robot", "true", "dependabot[bot]", False),
        ("pull_request", "stranger/robot", "true", "lab", False),
        ("pull_request", None, "true", "lab", False),
        ("pull_request_target", "lab/robot", "true", "lab", False),
        ("issue_comment", "lab/robot", "true", "lab", False),
    ],
)
def test_an_image_to_be_tried_is_published_for_our_own_pull_requests_alone(
    tmp_path: Path, name: str, head: str | None, wish: event.Push, actor: str, *, push: bool
) -> None:
    payload = pull_request(head)
    payload["pull_request"]["number"] = 7
    found = read(tmp_path, name, payload, GITHUB_ACTOR=actor)
    assert event.publication(found, wish, "image").push == push
    assert not event.publication(found, wish, "archive").push
    closed = read(tmp_path, name, {**payload, "action": "closed"}, GITHUB_ACTOR=actor)
    assert name != "pull_request" or not event.publication(closed, wish, "image").push


def test_who_wants_to_publish_a_pull_request_learns_how(tmp_path: Path) -> None:
    payload = pull_request("lab/robot")
    payload["pull_request"]["number"] = 7
    warning = event.publication(read(tmp_path, "pull_request", payload), "true").warning
    assert warning
    assert "`pr: image` in roslab.yaml" in warning


@pytest.mark.parametrize(
    "payload",
    [pull_request("stranger/robot"), pull_request(None), {"pull_request": {}}, {}],
    ids=["fork", "deleted fork", "no head", "nothing"],
)
def test_a_strangers_code_with_our_rights_is_refused(tmp_path: Path, payload: dict[str, Any]) -> None:
    with pytest.raises(RefusedError, match="refused: pull_request_target") as caught:
        read(tmp_path, "pull_request_target", payload)
    assert caught.value.exit_code == 4


def test_pull_request_target_of_our_own_branch_builds_only(tmp_path: Path) -> None:
    found = read(tmp_path, "pull_request_target", pull_request("Lab/Robot"))
    assert not event.publication(found, "true").push


@pytest.mark.parametrize(
    ("started_by", "head", "refused"),
    [
        ("pull_request", "stranger/robot", True),
        ("pull_request", "lab/robot", False),
        ("push", "stranger/robot", True),
        ("push", None, True),
    ],
)
def test_workflow_run(tmp_path: Path, started_by: str, head: str | None, *, refused: bool) -> None:
    payload = {"workflow_run": {"event": started_by, "head_repository": {"full_name": head} if head else None}}
    if refused:
        with pytest.raises(RefusedError):
            read(tmp_path, "workflow_run", payload)
    else:
        assert not event.publication(read(tmp_path, "workflow_run", payload), "true").push


@pytest.mark.parametrize("name", ["merge_group", "issues", "fork", "watch"])
def test_other_events_are_not_published_of_themselves(tmp_path: Path, name: str) -> None:
    assert not event.publication(read(tmp_path, name, {}), "auto").push


def test_a_comment_on_a_pull_request_does_not_publish(tmp_path: Path) -> None:
    found = read(tmp_path, "issue_comment", {"issue": {"pull_request": {"url": "…"}}})
    assert not event.publication(found, "true").push


def test_dependabot_holds_a_token_that_may_only_read(tmp_path: Path) -> None:
    found = read(tmp_path, "push", {}, GITHUB_ACTOR="dependabot[bot]")
    assert not event.publication(found, "auto").push
    assert event.publication(found, "true").warning


def test_a_merge_queues_push_is_not_published(tmp_path: Path) -> None:
    """Its branches fire both events, and the code on them is not merged yet."""
    found = read(tmp_path, "push", {}, GITHUB_REF="refs/heads/gh-readonly-queue/main/pr-7-" + "0" * 40)
    assert not event.publication(found, "auto").push
    assert event.publication(found, "true").warning


@pytest.mark.parametrize(
    ("payload", "public"),
    [({"private": False}, True), ({"private": True}, False), ({}, False), ({"private": None}, False)],
    ids=str,
)
def test_what_is_not_known_to_be_public_is_private(tmp_path: Path, payload: dict[str, Any], *, public: bool) -> None:
    assert read(tmp_path, "push", {"repository": payload}).public is public


def test_a_schedule_says_its_branch_by_the_ref_alone(tmp_path: Path) -> None:
    found = read(tmp_path, "schedule", {"repository": None}, GITHUB_REF="refs/heads/trunk")
    assert (found.branch, found.default_branch, found.public) == ("trunk", "trunk", False)
    assert read(tmp_path, "push", {"repository": None}, GITHUB_REF="refs/heads/trunk").default_branch == "main"


def test_refs(tmp_path: Path) -> None:
    assert read(tmp_path, "push", {}, GITHUB_REF="refs/heads/a/b").branch == "a/b"
    assert read(tmp_path, "push", {}, GITHUB_REF="refs/tags/v1").tag == "v1"
    pull = read(tmp_path, "pull_request", pull_request("lab/robot"), GITHUB_REF="refs/pull/7/merge")
    assert (pull.branch, pull.tag, pull.base_branch) == (None, None, "main")


def test_outside_a_workflow(tmp_path: Path) -> None:
    with pytest.raises(ConfigurationError, match="GITHUB_EVENT_NAME is not set"):
        event.read({})
    with pytest.raises(ConfigurationError, match="cannot read the event"):
        read(tmp_path, "push", {}, GITHUB_EVENT_PATH=str(tmp_path / "absent"))
