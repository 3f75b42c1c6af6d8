"""An old commit gets its own tag and its git tag's, never those of the branch that started the run."""

from __future__ import annotations

import pytest

from roslab.github import rebuild, tags
from roslab.github.event import Event

IMAGE = "ghcr.io/lab/robot"
OLD = "b" * 40
RUN = Event(
    name="workflow_dispatch", repository="lab/robot", ref="refs/heads/main", sha="a" * 40, default_branch="main"
)


@pytest.mark.parametrize(
    ("rebuilt", "moving"),
    [("", []), ("refs/tags/v1.2.3", ["v1.2.3", "1.2.3", "1.2"]), ("refs/tags/iros2019", ["iros2019"])],
)
def test_what_an_old_commit_is_called(rebuilt: str, moving: list[str]) -> None:
    what = rebuild.event_of(RUN, rebuilt, OLD)
    said = rebuild.names(what, IMAGE)
    assert tags.own(said, IMAGE, what) == f"{IMAGE}:sha-bbbbbbb"
    found = tags.chosen(said, IMAGE, what, head="a" * 40, releases=["v1.2.3"])
    assert [name.removeprefix(f"{IMAGE}:") for name in found.moving] == moving


def test_a_newer_release_keeps_its_series() -> None:
    what = rebuild.event_of(RUN, "refs/tags/v1.2.3", OLD)
    found = tags.chosen(rebuild.names(what, IMAGE), IMAGE, what, head=None, releases=["v1.2.3", "v1.2.4"])
    assert f"{IMAGE}:1.2" not in found.moving


def test_the_events_own_commit_is_left_as_it_is() -> None:
    assert rebuild.event_of(RUN, None, OLD) is RUN
