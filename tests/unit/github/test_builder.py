"""Which platforms need an emulator, and which build failed."""

from __future__ import annotations

from pathlib import Path

from roslab.github import builder

INSPECTION = """\
Name:          default
Driver:        docker
Nodes:
Name:             default
Status:           running
Platforms:        linux/amd64*, linux/amd64/v2, linux/386, linux/arm64
"""
HISTORY = """\
{"name": "a", "ref": "default/default/newest", "status": "Completed"}
not json
{"name": "a", "ref": "default/default/middle", "status": "Error"}
{"name": "a", "ref": "default/default/oldest", "status": "Error"}
"""


def test_platforms_that_a_builder_lists() -> None:
    assert builder.listed(INSPECTION) == ("linux/amd64", "linux/amd64/v2", "linux/386", "linux/arm64")
    assert builder.listed("") == ()


def test_the_newest_failed_build(tmp_path: Path) -> None:
    assert builder.newest_failure(HISTORY, tmp_path) == "middle"
    assert builder.newest_failure("", tmp_path) is None


def test_a_failed_build_of_another_job_on_the_same_buildkit_is_not_explained(tmp_path: Path) -> None:
    notes = tmp_path / "default" / "default"
    notes.mkdir(parents=True)
    assert builder.newest_failure(HISTORY, tmp_path) is None
    (notes / "oldest").write_text("{}")
    assert builder.newest_failure(HISTORY, tmp_path) == "oldest"


def test_one_platform_that_is_not_pushed_is_built_by_the_engine_unless_a_machine_names_another() -> None:
    assert builder.settings({}, direct=True)["driver"] == "docker"
    assert builder.settings({}, direct=True)["driver-opts"] == ""
    assert builder.settings({"ROSLAB_BUILDX_DRIVER": "remote"}, direct=True)["driver"] == "remote"
