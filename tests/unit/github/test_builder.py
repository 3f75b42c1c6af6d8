"""Which platforms need an emulator, and which build failed."""

from __future__ import annotations

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


def test_the_newest_failed_build() -> None:
    assert builder.newest_failure(HISTORY) == "middle"
    assert builder.newest_failure("") is None


def test_one_platform_that_is_not_pushed_is_built_by_the_engine_unless_a_machine_names_another() -> None:
    assert builder.settings({}, direct=True)["driver"] == "docker"
    assert builder.settings({}, direct=True)["driver-opts"] == ""
    assert builder.settings({"ROSLAB_BUILDX_DRIVER": "remote"}, direct=True)["driver"] == "remote"
