"""A disk that holds an image once and not twice: what is done for it, and what is said where that is not enough."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from lab import doors, facts, network
from lab.act import Result, run_workflow
from lab.laboratory import Laboratory
from lab.small_disk import small_disk

DOCKERFILE = """\
FROM ubuntu:24.04
RUN head --bytes=400M /dev/urandom >/weights
CMD ["true"]
"""


def run(lab: Laboratory, place: Path, repository: str, dockerfile: str, **settings: str) -> Result:
    caller = doors.through_action(
        place,
        {"registry": lab.registry, "platforms": "linux/amd64", "cache": "none"},
        {
            "Dockerfile": dockerfile,
            "roslab.yaml": "format: 3\nkind: cpp\ndockerfile: Dockerfile\ntest: test -s /weights\n",
        },
    )
    payload = doors.payload(repository.partition("/")[2])
    environment = {**doors.builder(lab), **settings}
    return run_workflow(lab, caller, "push", payload, env=environment)


@pytest.mark.parametrize("pruned", [True, False], ids=["emptied", "kept"])
def test_an_image_fits_once_the_builders_store_is_emptied(lab: Laboratory, tmp_path: Path, pruned: bool) -> None:
    """About 1.1 GB in BuildKit's store, as much in the engine's, and 1.7 GB of disk."""
    repository = lab.fresh_repository(f"{doors.OWNER}/robot").partition("/")[2]
    with small_disk(lab, 1700) as small:
        ran = run(small, tmp_path / "caller", repository, DOCKERFILE, ROSLAB_BUILDX_PRUNE=str(pruned).lower())
    if pruned:
        assert ran.exit_code == 0, ran.log
        assert "BuildKit's store is emptied" in ran.log
        assert "main" in doors.tags(repository)
    else:
        assert ran.exit_code != 0
        assert [error for error in doors.errors(ran) if "needs about" in error and "to be run" in error], ran.log


def test_a_base_that_cannot_fit_is_told_before_the_build(lab: Laboratory, tmp_path: Path) -> None:
    repository = lab.fresh_repository(f"{doors.OWNER}/robot").partition("/")[2]
    mirror = f"127.0.0.1:{facts.number('registry', 'mirror_port')}"
    with small_disk(lab, 500) as small:
        ran = run(small, tmp_path / "caller", repository, f"FROM {mirror}/library/python:3.11\nRUN echo built\n")
    assert ran.exit_code != 0
    assert [error for error in doors.errors(ran) if "library/python:3.11 alone needs about 0.7 GB" in error], ran.log
    assert "Main Build" not in ran.log


@pytest.mark.parametrize("builder", ["the engine's own", "another"])
def test_a_pull_requests_image_is_exported_once(lab: Laboratory, tmp_path: Path, builder: str) -> None:
    """Where nothing names another, the engine's own BuildKit builds it, and the engine has it without a copy."""
    if builder == "the engine's own" and os.environ.get("REPRO_LAB_ACTIONS") and not network.real_registry():
        pytest.skip("the real setup-buildx-action fetches the pinned buildx from GitHub, which is out of reach")
    repository = lab.fresh_repository(f"{doors.OWNER}/robot").partition("/")[2]
    files = {"Dockerfile": "FROM ubuntu:24.04\nRUN uname -m >/machine\n"}
    caller = doors.through_action(tmp_path, {"registry": lab.registry, "platforms": "linux/amd64"}, files)
    payload = doors.payload(repository.partition("/")[2], head=repository)
    named = doors.builder(lab) if builder == "another" else {}
    ran = run_workflow(lab, caller, "pull_request", payload, env=named)
    assert ran.exit_code == 0, ran.log
    assert ran.output("driver") == ("remote" if builder == "another" else "docker")
    built, _, prove = ran.log.partition("Load and prove")
    step = "[2/2] RUN uname -m >/machine"  # not its first: BuildKit names that after any build that shares it
    assert step in built
    assert step not in prove, "the proof builds nothing again"
    assert "x86_64" in prove
    assert "Built and proved, not published" in ran.summary
