"""The second of two pushes on a runner that has nothing yet, and whose cache mounts a shared builder keeps."""

from __future__ import annotations

import re
import secrets
from dataclasses import replace
from pathlib import Path

import pytest

from lab import buildkit, doors, records, registry
from lab.act import Result, run_workflow
from lab.laboratory import Laboratory
from lab.records import Step
from roslab.engine import docker
from roslab.github import cache
from roslab.github.event import Event, publication
from roslab.github.tree import Carrier, keep, take
from roslab.pipeline import plan_repository
from roslab.render.layers.compiler_cache import tree_mount

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


@pytest.mark.parametrize("door", ["action", "image"])
def test_the_second_of_two_pushes(lab: Laboratory, tmp_path: Path, door: str) -> None:
    """Nothing but the cache is left of the first, all of whose RUNs ran; in the second none does."""
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    through = doors.through_action if door == "action" else doors.through_workflow
    given = {"registry": lab.registry, "cache": "registry"}
    caller = through(tmp_path / "caller", given, {"Dockerfile": RECIPE, ".dockerignore": IGNORED})
    _, first = push(lab, caller, name, tmp_path / "first")
    _, second = push(lab, caller, name, tmp_path / "second")
    for pushed in (first, second):
        assert len(pushed) == (1 if door == "action" else 2)  # one build of two platforms, or one for each
        assert sum(map(len, pushed)) == 2 * RUNS
        assert not [step for build in pushed for step in build if step.failed]
    assert not [step for build in first for step in build if step.cached]
    assert [step.name for build in second for step in build if not step.cached] == []
    parts = {"action": ["all"], "image": ["linux-amd64", "linux-arm64"]}[door]
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
    build("proposal", nothing, "pull_request", head=repository)
    build("push", nothing, "push")
    build("again", "grep push /found/who", "push")
    build("release", nothing, "push", ref="refs/tags/v1.0.0")


COMPILING = """\
FROM ubuntu:24.04 AS compiled
ARG TARGETARCH
ARG NB_UID=1000
COPY who /who
RUN {mount} cd /var/cache/roslab-build && mkdir /found && {{ cat tree/who || echo nobody; }} >/found/who \\
 && rm -rf tree && mkdir tree && cp /who tree/who && cp /who contents && echo same >fingerprint
FROM scratch
COPY --from=compiled /found /
"""
"""Keeps its tree as ``reuse-build`` does, and tells whose it found."""


def test_a_build_tree_travels_through_the_registry_and_a_pull_requests_reaches_nobody(
    lab: Laboratory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Builds with the decisions and the steps of the workflows; the second builder has nothing but the registry."""
    image = f"{lab.mirror}/lab/tree-{secrets.token_hex(4)}"
    planned = plan_repository(Path(__file__).parents[2] / "examples/ros1_talker").plan
    plan = replace(planned, base_image="ubuntu:24.04")
    (tmp_path / "Dockerfile").write_text(COMPILING.format(mount=tree_mount(plan)))
    for name, value in {**lab.environment, "DOCKER_HOST": lab.docker_host, "BUILDX_BUILDER": "records"}.items():
        monkeypatch.setenv(name, value)

    def build(who: str, **said: object) -> str:
        usual = {"name": "push", "repository": "lab/robot", "ref": "refs/heads/main", "default_branch": "main"}
        what = Event(**{"sha": "0" * 40, "head": "lab/robot", **usual, **said})  # type: ignore[arg-type]
        published = publication(what, "auto")
        kept = cache.tree(what, published, "registry", image=image, part="linux-amd64")
        mounts = cache.mounts(what, "registry")
        carrier = Carrier(plan=plan, folder=tmp_path, platforms=("linux/amd64",), mounts=mounts)
        take(carrier, kept.read)
        (tmp_path / "who").write_text(who)
        layers = cache.layers(what, published, "registry", image=image, part="linux-amd64")
        job = docker.Build(
            context=tmp_path,
            dockerfile=tmp_path / "Dockerfile",
            platforms=carrier.platforms,
            arguments=(("BUILDKIT_CACHE_MOUNT_NS", mounts),),
            output=f"type=local,dest={tmp_path / 'found'}",
            extra=(*(f"--cache-from={x}" for x in layers.read), *(f"--cache-to={x}" for x in layers.write)),
        )
        docker.build(job)
        keep(carrier, kept.write)
        return (tmp_path / "found/who").read_text().strip()

    pull: dict[str, object] = {
        "name": "pull_request",
        "ref": "refs/pull/7/merge",
        "proposed": True,
        "base_branch": "main",
    }
    runners: list[list[tuple[str, dict[str, object], str]]] = [
        [("a pull request", pull, "nobody"), ("a push", {}, "nobody")],
        [("another", pull, "a push"), ("its successor", {}, "a push"), ("v1", {"ref": "refs/tags/v1.0.0"}, "nobody")],
    ]
    for number, builds in enumerate(runners):
        with (
            buildkit.fresh(tmp_path / f"builder-{number}") as address,
            records.records(address, lab.docker_host) as history,
        ):
            monkeypatch.setenv("BUILDX_CONFIG", history.environment["BUILDX_CONFIG"])
            for who, said, found in builds:
                assert build(who, **said) == found, who
    assert [name for name in registry.tags(image.partition("/")[2], name=registry.MIRROR) if name.endswith(".tree")]
