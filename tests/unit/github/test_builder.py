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


def test_a_runner_gets_a_buildkit_of_its_own_unless_a_machine_names_one() -> None:
    assert builder.settings({}) == {"driver": "docker-container", "endpoint": ""}
    named = {"ROSLAB_BUILDX_DRIVER": "remote", "ROSLAB_BUILDX_ENDPOINT": "unix:///run/buildkitd.sock"}
    assert builder.settings(named) == {"driver": "remote", "endpoint": "unix:///run/buildkitd.sock"}


def test_a_bill_of_materials_is_written_on_a_runner_and_under_act_where_it_is_asked_for() -> None:
    assert builder.scanner({}, act=False)
    assert not builder.scanner({}, act=True)
    assert builder.scanner({"ROSLAB_SBOM": "true"}, act=True)
    assert not builder.scanner({"ROSLAB_SBOM": "false"}, act=False)
