"""Which tags move to an image, and which would move back, or mean something else."""

from __future__ import annotations

import pytest

from roslab.config.model import TagParts
from roslab.errors import ConfigurationError
from roslab.github import tags
from roslab.github.event import Event

IMAGE = "ghcr.io/lab/robot"
COMMIT = "a" * 40


def event(ref: str) -> Event:
    return Event(name="push", repository="lab/robot", ref=ref, sha=COMMIT, default_branch="main")


def chosen(ref: str, *names: str, head: str | None = COMMIT, releases: tuple[str, ...] = ()) -> tags.Chosen:
    said = "\n".join(f"{IMAGE}:{name}" for name in (*names, "sha-aaaaaaa"))
    return tags.chosen(said, IMAGE, event(ref), head=head, releases=releases)


def names(found: tags.Chosen) -> list[str]:
    return [reference.removeprefix(f"{IMAGE}:") for reference in found.moving]


def test_a_branch_whose_head_is_this_commit() -> None:
    found = chosen("refs/heads/main", "main", "latest")
    assert names(found) == ["main", "latest"]
    assert found.warnings == ()


@pytest.mark.parametrize(("head", "why"), [("b" * 40, "is at bbbbbbbbbbbb now"), (None, "is gone")])
def test_an_old_commit_moves_no_tag_of_its_branch_back(head: str | None, why: str) -> None:
    found = chosen("refs/heads/main", "nightly", "main", "latest", head=head)
    assert names(found) == []
    assert found.warnings == (f"nightly, main, latest: not moved to aaaaaaaaaaaa, since the branch main {why}",)


@pytest.mark.parametrize("branch", ["latest", "1.2.3", "v1", "1.2", "v2.0.0-rc1", "nightly", "sha-abcdef0", "pr-7"])
def test_a_branch_that_is_called_like_something_else(branch: str) -> None:
    found = chosen(f"refs/heads/{branch}", branch)
    assert names(found) == []
    assert f"the branch {branch} gets no tag of its name" in found.warnings[0]


@pytest.mark.parametrize("branch", ["humble", "noetic-devel", "release/1.2", "latest-fixes", "ros2", "2-arms"])
def test_a_branch_with_a_name_of_its_own(branch: str) -> None:
    name = branch.replace("/", "-")
    assert names(chosen(f"refs/heads/{branch}", name)) == [name]


def test_a_pull_request_has_one_tag() -> None:
    """Its commits' tags would stay for ever: they are merges that no branch ever has."""
    what = Event(
        name="pull_request", repository="lab/robot", ref="refs/pull/7/merge", sha=COMMIT, default_branch="main",
        proposed=True, head="lab/robot", pull=7,
    )  # fmt: skip
    said = f"{IMAGE}:pr-7\n{IMAGE}:sha-aaaaaaa"
    assert tags.own(said, IMAGE, what) == f"{IMAGE}:pr-7"
    assert (
        tags.dressed(tags.own(said, IMAGE, what), TagParts(prefix="a-", suffix="-humble")) == f"{IMAGE}:a-pr-7-humble"
    )
    assert tags.chosen(said, IMAGE, what, head=COMMIT).moving == ()


def test_the_default_branch_may_be_called_latest() -> None:
    said = f"{IMAGE}:latest\n{IMAGE}:sha-aaaaaaa"
    what = Event(name="push", repository="lab/robot", ref="refs/heads/latest", sha=COMMIT, default_branch="latest")
    assert tags.chosen(said, IMAGE, what, head=COMMIT).moving == (f"{IMAGE}:latest",)


@pytest.mark.parametrize("name", ["latest", "main", "nightly"])
def test_a_git_tag_does_not_take_a_branchs_place(name: str) -> None:
    found = chosen(f"refs/tags/{name}", name)
    assert names(found) == []
    assert f"the git tag {name} gets no tag of its name" in found.warnings[0]


def test_a_release_moves_its_series_forward_only() -> None:
    newer = chosen("refs/tags/v1.2.3", "v1.2.3", "1.2.3", "1.2", head=None, releases=("v1.2.3", "v1.2.10", "v1.3.0"))
    assert names(newer) == ["v1.2.3", "1.2.3"]
    assert newer.warnings == ("1.2: not moved back to v1.2.3, since v1.2.10 is newer",)
    newest = chosen("refs/tags/v1.2.3", "v1.2.3", "1.2.3", "1.2", head=None, releases=("v1.2.2", "v1.2.3", "v1.2.x"))
    assert names(newest) == ["v1.2.3", "1.2.3", "1.2"]


def test_the_commits_own_tag() -> None:
    what = event("refs/heads/sha-abcdef0")
    assert tags.own(f"{IMAGE}:sha-abcdef0\n{IMAGE}:sha-aaaaaaa\n", IMAGE, what) == f"{IMAGE}:sha-aaaaaaa"
    with pytest.raises(ConfigurationError, match="no tag sha-aaaaaaa"):
        tags.own(f"{IMAGE}:main\n{IMAGE}:sha-abcdef0", IMAGE, what)
    with pytest.raises(ConfigurationError, match=r"were expected, not ghcr\.io/else/where:main"):
        tags.own("ghcr.io/else/where:main", IMAGE, what)


def test_a_prefix_and_a_suffix_stand_around_every_tag() -> None:
    parts = TagParts(prefix="ros-", suffix="-humble")
    assert tags.dressed(f"{IMAGE}:main", parts) == f"{IMAGE}:ros-main-humble"
    assert tags.dressed(f"127.0.0.1:5000/lab/robot:{'x' * 128}", parts).rpartition(":")[2].endswith("x-humble")
    assert len(tags.dressed(f"{IMAGE}:{'x' * 128}", parts).rpartition(":")[2]) == 128
