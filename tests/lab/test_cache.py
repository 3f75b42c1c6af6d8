"""The second of two pushes on a runner that has nothing yet, and whose cache mounts a shared builder keeps."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from lab import buildkit, doors, records, registry
from lab.act import Result, run_workflow
from lab.laboratory import Laboratory
from lab.records import Step

RECIPE = """\
FROM ubuntu:24.04 AS library
RUN date +%s%N > /library
FROM ubuntu:24.04
RUN date +%s%N > /when
COPY --from=library /library /library
COPY . /source
RUN cat /when /library && uname -m > /machine
CMD ["cat", "/machine"]
"""
IGNORED = ".git\n"
"""Of the context, as in a generated recipe: git's index holds times and inodes, which no two checkouts share."""
RUNS = 3
"""RUN steps of the recipe, for each platform."""


def push(lab: Laboratory, caller: Path, name: str, runner: Path) -> tuple[Result, list[tuple[Step, ...]]]:
    """Push on a fresh runner; return what came of it and the RUN steps of each of its builds."""
    with buildkit.fresh(runner) as address, records.records(address, lab.docker_host) as history:
        builder = {"ROSLAB_BUILDX_DRIVER": "remote", "ROSLAB_BUILDX_ENDPOINT": address}
        ran = run_workflow(lab, caller, "push", doors.payload(name), env=builder)
        assert ran.exit_code == 0, ran.log
        builds = history.builds()
        assert {build["status"] for build in builds} == {"Completed"}
        return ran, [tuple(step for step in history.steps(build) if step.runs) for build in builds]


@pytest.mark.parametrize(("door", "cache"), [("action", "registry"), ("image", "registry"), ("image", "none")])
def test_the_second_of_two_pushes(lab: Laboratory, tmp_path: Path, door: str, cache: str) -> None:
    """With the cache no RUN of an unchanged repository runs again; without it every one does."""
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    through = doors.through_action if door == "action" else doors.through_workflow
    given = {"registry": lab.registry, "cache": cache}
    caller = through(tmp_path / "caller", given, {"Dockerfile": RECIPE, ".dockerignore": IGNORED})
    _, first = push(lab, caller, name, tmp_path / "first")
    _, second = push(lab, caller, name, tmp_path / "second")
    for pushed in (first, second):
        assert len(pushed) == (1 if door == "action" else 2)  # one build of two platforms, or one for each
        assert sum(map(len, pushed)) == 2 * RUNS
        assert not [step for build in pushed for step in build if step.failed]
    assert not [step for build in first for step in build if step.cached]
    executed = [step.name for build in second for step in build if not step.cached]
    assert len(executed) == (0 if cache == "registry" else 2 * RUNS), executed
    parts = {"action": ["all"], "image": ["linux-amd64", "linux-arm64"]}[door] if cache == "registry" else []
    caches = [tag for tag in registry.tags(f"{doors.OWNER}/{name}") if tag.startswith("buildcache-")]
    assert [re.sub("-[0-9a-f]{8}-", "-", name) for name in caches] == [f"buildcache-main-{part}" for part in parts]


KEEPING = """\
FROM ubuntu:24.04
COPY . /source
RUN --mount=type=cache,id=kept,target=/kept cp --recursive /kept /found && cat /source/who >/kept/who
CMD ["ls", "/found"]
"""


def test_what_a_pull_request_keeps_in_a_cache_mount_reaches_no_branch_and_no_release(
    lab: Laboratory, tmp_path: Path
) -> None:
    """One builder for all, as on a runner of one's own: only the branch itself finds what it kept."""
    repository = lab.fresh_repository(f"{doors.OWNER}/robot").partition("/")[2]
    name = repository.rpartition("/")[2]

    def build(who: str, test: str, event: str, **said: str) -> None:
        recipe = f"format: 3\nkind: cpp\ndockerfile: Dockerfile\nplatforms: [linux/amd64]\ntest: {test}\n"
        files = {"Dockerfile": KEEPING, "roslab.yaml": recipe, "who": who}
        caller = doors.through_action(tmp_path / who, {"registry": lab.registry}, files)
        ran = run_workflow(lab, caller, event, doors.payload(name, **said), env=doors.builder(lab))
        assert ran.exit_code == 0, ran.log

    nothing = "test ! -e /found/who"
    build("stranger", nothing, "pull_request", head="stranger/robot")
    build("proposal", nothing, "pull_request", head=repository)
    build("push", nothing, "push")
    build("again", "grep push /found/who", "push")
    build("release", nothing, "push", ref="refs/tags/v1.0.0")
