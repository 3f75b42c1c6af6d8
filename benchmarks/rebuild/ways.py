"""The ways of building: what the Dockerfile says, what a build is given, and what is left for the next one."""

from __future__ import annotations

import os
import secrets
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from unittest.mock import patch

from benchmarks.rebuild.builds import Builder, FailedBuildError, Figures, Registry, builder, figures, registry
from benchmarks.rebuild.repositories import Change
from lab import engine
from roslab.engine.docker import native_platform
from roslab.github.tree import Carrier, keep, source_of, take
from roslab.pipeline import plan_repository

SCRIPTS = Path(__file__).resolve().parent.parent.parent / "scripts"
CASES = ("cold", "unchanged", "edit-cpp", "edit-launch", "add-apt", "add-package-xml", "edit-readme")
WARM = "warm-container"
"""The way that builds no image: make in a container which has everything and the last build's tree."""
WAYS = ("paper", "docker-ros", "ours", "paper-fresh-runner", "ours-fresh-runner", WARM)
FRESH = "-fresh-runner"
"""End of a way whose every build has an empty builder, and what the registry kept."""
IMAGE = "bench/image"

# The order of the Dockerfiles in the article of 2024 (algorithms 1 and 5): the whole tree, then what it needs
INSTALLED = """\
FROM ros:noetic-ros-base
RUN mkdir -p /catkin_ws/src
COPY . /catkin_ws/src/
RUN . /opt/ros/$ROS_DISTRO/setup.sh \\
  && apt-get update \\
  && DEBIAN_FRONTEND=noninteractive rosdep install -y --from-paths /catkin_ws/src --ignore-src{apt} \\
  && rm -rf /var/lib/apt/lists/*
"""
PAPER = f"""\
{INSTALLED}\
RUN . /opt/ros/$ROS_DISTRO/setup.sh && cd /catkin_ws && catkin_make
RUN sed --in-place --expression '$isource "/catkin_ws/devel/setup.bash"' /ros_entrypoint.sh
CMD ["bash"]
"""
MAKE = ". /opt/ros/$ROS_DISTRO/setup.sh && cd /catkin_ws && catkin_make -DCMAKE_BUILD_TYPE=Release"
PAPER_APT = " \\\n  && DEBIAN_FRONTEND=noninteractive apt-get install -y {packages}"

# docker-ros as its documentation describes it: a stage for what is needed, one for the build, each given a token that
# is another at every run
DOCKER_ROS = """\
FROM ros:noetic-ros-base AS dependencies
ARG TOKEN
RUN apt-get update && apt-get install -y --no-install-recommends python3-pip && rm -rf /var/lib/apt/lists/*
WORKDIR /docker-ros/ws
COPY . src/target
RUN . /opt/ros/$ROS_DISTRO/setup.sh \\
  && rosdep install --simulate --from-paths src --ignore-src -y > /docker-ros/dependencies.txt \\
  && apt-get update \\
  && DEBIAN_FRONTEND=noninteractive rosdep install -y --from-paths src --ignore-src{apt} \\
  && rm -rf /var/lib/apt/lists/*
FROM dependencies AS build
ARG TOKEN
RUN . /opt/ros/$ROS_DISTRO/setup.sh && catkin_make -DCMAKE_BUILD_TYPE=Release
CMD ["bash"]
"""


@dataclass(frozen=True, kw_only=True)
class Job:
    """One build: a way, its Dockerfile, the repository as it is, and the case that it is measured for."""

    way: str
    dockerfile: Path
    context: Path
    case: str


def measure(
    way: str, change: Change, place: Path, cases: tuple[str, ...], rounds: int = 1
) -> Iterator[tuple[str, Figures]]:
    """Build a repository one way, cold and again after each change, in turn; the changes add up.

    ``place`` is an empty folder. An edit is made and measured ``rounds`` times, and the median of the seconds counts.
    Raises ``FailedBuildError``.
    """
    if way == WARM:
        yield from _measure_container(change, place, cases, rounds)
        return
    with ExitStack() as stack:
        pushed = stack.enter_context(registry())
        runner = None if way.endswith(FRESH) else stack.enter_context(builder())

        def build(case: str) -> Figures:
            change.make(case)
            job = Job(way=way, dockerfile=_dockerfile(way, change, place), context=change.root, case=case)
            if runner:
                return _build(runner, pushed, job)
            with builder() as empty:
                return _build(empty, pushed, job)

        for case in cases:
            found = _median([build(case) for _ in range(_times(case, rounds))])
            print(f"{change.of.name} {way} {case}: {found}", file=sys.stderr, flush=True)
            yield case, found


def _times(case: str, rounds: int) -> int:
    """How often a case is measured: what is added is there after the first time."""
    return rounds if case.startswith("edit-") else 1


def _median(found: list[Figures]) -> Figures:
    return sorted(found, key=lambda one: one.seconds)[len(found) // 2]


def _measure_container(
    change: Change, place: Path, cases: tuple[str, ...], rounds: int
) -> Iterator[tuple[str, Figures]]:
    """Compile in one container, again after each change of what it compiles: no image, no push, nothing installed."""
    name = f"roslab-bench-{secrets.token_hex(4)}"
    (place / "Dockerfile").write_text(INSTALLED.replace("{apt}", ""))
    _docker("buildx", "build", "--load", "--tag", name, "--file", place / "Dockerfile", change.root)
    _docker("run", "--detach", "--name", name, "--volume", f"{change.root}:/catkin_ws/src", name, "sleep", "infinity")
    try:
        for case in cases:
            if case in {"add-apt", "add-package-xml"}:
                continue
            seconds = []
            for _ in range(_times(case, rounds)):
                change.make(case)
                started = time.monotonic()
                _docker("exec", name, "bash", "-c", MAKE)
                seconds.append(time.monotonic() - started)
            found = _median([Figures(round(one, 2), 0, 0, 0, 0) for one in seconds])
            print(f"{change.of.name} {WARM} {case}: {found}", file=sys.stderr, flush=True)
            yield case, found
    finally:
        _docker("rm", "--force", name)
        _docker("rmi", "--force", name)


@cache
def _host() -> str:
    return engine.host() or engine.own_host()


def _docker(*words: str | Path) -> None:
    """Call the lab's engine. Raises ``FailedBuildError``."""
    environment = {**os.environ, "DOCKER_HOST": _host()}
    command = ["docker", *map(str, words)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=3600, check=False)
    if done.returncode:
        raise FailedBuildError(f"docker {words[0]}: {(done.stdout + done.stderr)[-6000:]}")


def _build(runner: Builder, pushed: Registry, job: Job) -> Figures:
    name = f"{pushed.address}/{IMAGE}:{job.case}"
    words: list[str | Path] = ["--file", job.dockerfile, "--output", f"type=image,name={name},push=true"]
    if job.way == "docker-ros":
        words += ["--build-arg", f"TOKEN={secrets.token_hex(8)}"]
    if job.way.endswith(FRESH):
        cache = f"type=registry,ref={pushed.address}/{IMAGE}:buildcache"
        words += ["--cache-from", cache, "--cache-to", f"{cache},mode=max,ignore-error=true"]
    started = time.monotonic()
    if job.way == f"ours{FRESH}":
        log = _build_with_tree(runner, f"{pushed.address}/{IMAGE}:buildcache.tree", words, job)
    else:
        log = runner.build(words, job.context)
    seconds = time.monotonic() - started
    return figures(log, seconds, *pushed.received(f"{IMAGE}:{job.case}"))


def _build_with_tree(runner: Builder, tree: str, words: list[str | Path], job: Job) -> str:
    """Build as the workflows do: the last build's tree is fetched before, and this build's is kept after it."""
    plan = plan_repository(job.context).plan
    _commit(job.context)
    source = source_of(plan, job.context)
    platforms = (native_platform(),)
    carried = Carrier(plan=plan, folder=job.dockerfile.parent, platforms=platforms, mounts="bench", source=source)
    with patch.dict(os.environ, {**runner.environment, "BUILDX_BUILDER": "bench"}):
        take(carried, (tree,))
        log = runner.build([*words, "--build-arg", f"BUILDKIT_CACHE_MOUNT_NS={carried.mounts}"], job.context)
        keep(carried, tree)
    return log


def _commit(folder: Path) -> None:
    """Commit what is there: a workflow builds commits."""
    git = ["git", "-C", str(folder), "-c", "user.name=bench", "-c", "user.email=bench@example.org"]
    for words in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--allow-empty", "--message", "again"]):
        subprocess.run([*git, *words], check=True)


def _dockerfile(way: str, change: Change, place: Path) -> Path:
    """Write the Dockerfile of a way as it is after the change, out of the repository."""
    if text := {"paper": PAPER, "docker-ros": DOCKER_ROS}.get(way.removesuffix(FRESH)):
        apt = PAPER_APT.format(packages=" ".join(change.apt)) if change.apt else ""
        file = place / "Dockerfile"
        file.write_text(text.replace("{apt}", apt))
        # As in ours: the history is another at every commit
        (place / "Dockerfile.dockerignore").write_text("**/.git\n")
        return file
    command = [sys.executable, "-I", str(SCRIPTS), "create", str(change.root), "--output", str(place), "--force"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise FailedBuildError(done.stderr)
    return place / "Dockerfile"
