"""Labels are the same for the same commit."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from roslab.github.event import Event
from roslab.github.labels import labels, timestamp
from roslab.pipeline import plan_repository

EVENT = Event(name="push", repository="Lab/Robot", ref="refs/heads/main", sha="1" * 40, default_branch="main")


def test_labels(examples: Path) -> None:
    plan = plan_repository(examples / "python_filter", folder_name="Robot").plan
    found = dict(labels(plan, EVENT, revision="2" * 40, seconds=0))
    assert found["org.opencontainers.image.title"] == "robot"
    assert found["org.opencontainers.image.source"] == "https://github.com/Lab/Robot"
    assert found["org.opencontainers.image.revision"] == "2" * 40
    assert found["org.opencontainers.image.created"] == "1970-01-01T00:00:00Z"
    assert found["org.opencontainers.image.base.name"] == plan.base_image
    assert "org.opencontainers.image.description" not in found
    known = replace(EVENT, description='An arm, "soft"\nand slow ' + "x" * 600, licence="BSD-3-Clause")
    said = dict(labels(plan, known, revision="2" * 40, seconds=0))
    assert said["org.opencontainers.image.description"].startswith("An arm, soft and slow xxx")
    assert len(said["org.opencontainers.image.description"]) <= 512
    assert said["org.opencontainers.image.licenses"] == "BSD-3-Clause"
    without = dict(labels(plan, EVENT, revision="", seconds=None))
    assert without["org.opencontainers.image.revision"] == "1" * 40
    assert "org.opencontainers.image.created" not in without


def test_timestamp() -> None:
    assert timestamp(1_600_000_000) == "2020-09-13T12:26:40Z"
