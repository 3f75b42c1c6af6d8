"""The build tree is fetched where there is one, and kept where it is new and not too large; it fails no run."""

from __future__ import annotations

import json
import os
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from roslab.github.tree import LARGEST, SOURCE, Carrier, keep, source_of, take
from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan

EXAMPLE = Path(__file__).parents[3] / "examples/ros1_talker"
DIGEST = "sha256:" + "5" * 64
STANDIN = """\
#!/bin/bash
# A stand-in of docker: a registry with the images of $IMAGES, a builder whose tree has the size $SIZE
echo "$*" >>"$CALLS"
case "$*" in
  *"imagetools inspect"*)
    [[ " $IMAGES " == *" ${*: -1} "* || "$*" == *@* ]] || { echo "ERROR: ${*: -1}: not found" >&2; exit 1; }
    if [[ "$*" == *--raw* ]]; then cat "$MANIFEST"; else echo '{"digest": "DIGEST"}'; fi ;;
  *"--output type=local,dest="*)
    [[ "$*" =~ dest=([^ ]+) ]]; echo "$SIZE" >"${BASH_REMATCH[1]}/size" ;;
  *"buildx build"*) exit "${BUILD:-0}" ;;
esac
"""


class Docker:
    """What the stand-in was asked for."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder, self.monkeypatch = folder, monkeypatch
        (folder / "bin").mkdir()
        program = folder / "bin/docker"
        program.write_text(STANDIN.replace("DIGEST", DIGEST))
        program.chmod(0o755)
        monkeypatch.setenv("PATH", f"{folder / 'bin'}:{os.environ['PATH']}")
        monkeypatch.setenv("CALLS", str(folder / "calls"))
        monkeypatch.setenv("MANIFEST", str(folder / "manifest"))
        self.manifest({})
        self.has(images="", size="none")

    def has(self, **said: str) -> None:
        for name, value in said.items():
            self.monkeypatch.setenv(name.upper(), value)

    def manifest(self, annotations: dict[str, str]) -> None:
        (self.folder / "manifest").write_text(json.dumps({"annotations": annotations}))

    def builds(self) -> list[str]:
        """Return the builds since the last question, each in one line."""
        file = self.folder / "calls"
        calls = file.read_text().splitlines() if file.exists() else []
        file.unlink(missing_ok=True)
        return [call for call in calls if call.startswith("buildx build")]


@pytest.fixture
def docker(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Docker:
    return Docker(tmp_path, monkeypatch)


@pytest.fixture(scope="module")
def plan() -> Plan:
    return plan_repository(EXAMPLE).plan


def carrier(plan: Plan, folder: Path, source: str = "") -> Carrier:
    return Carrier(plan=plan, folder=folder, platforms=("linux/amd64",), mounts="branch-1", source=source)


OWN, DEFAULT = (
    "localhost:1/robot:buildcache-x-1-linux-amd64.tree",
    "localhost:1/robot:buildcache-main-2-linux-amd64.tree",
)


def test_the_nearest_tree_that_exists_is_taken_by_its_digest(docker: Docker, plan: Plan, tmp_path: Path) -> None:
    take(carrier(plan, tmp_path), (OWN, DEFAULT))
    assert docker.builds() == []
    docker.has(images=DEFAULT)
    take(carrier(plan, tmp_path), (OWN, DEFAULT))
    (build,) = docker.builds()
    assert f"--build-context before=docker-image://localhost:1/robot@{DIGEST}" in build
    assert "BUILDKIT_CACHE_MOUNT_NS=branch-1" in build
    docker.has(images=f"{OWN} {DEFAULT}")
    take(carrier(plan, tmp_path), (OWN, DEFAULT))
    assert len(docker.builds()) == 1


def test_a_tree_that_cannot_be_taken_or_kept_fails_no_run(docker: Docker, plan: Plan, tmp_path: Path) -> None:
    docker.has(images=OWN, size="5", build="1")
    take(carrier(plan, tmp_path), (OWN,))
    keep(carrier(plan, tmp_path), OWN)
    assert len(docker.builds()) == 3


def test_nothing_is_fetched_or_kept_for_the_source_of_which_the_kept_tree_is(
    docker: Docker, plan: Plan, tmp_path: Path
) -> None:
    docker.has(images=OWN, size="5")
    docker.manifest({SOURCE: "abc"})
    take(carrier(plan, tmp_path, "abc"), (OWN,))
    keep(carrier(plan, tmp_path, "abc"), OWN)
    assert docker.builds() == []
    take(carrier(plan, tmp_path, "def"), (OWN,))
    assert len(docker.builds()) == 1


@pytest.mark.parametrize(
    ("size", "kept"), [("none", False), ("same", False), (str(LARGEST), True), (str(LARGEST + 1), False)]
)
def test_only_a_new_tree_within_bounds_is_kept(
    docker: Docker, plan: Plan, tmp_path: Path, size: str, kept: bool
) -> None:
    docker.has(size=size)
    keep(carrier(plan, tmp_path, "abc"), OWN)
    pushed = [build for build in docker.builds() if "push=true" in build]
    assert len(pushed) == kept
    assert all("oci-mediatypes=true,compression=zstd" in build for build in pushed)
    assert all(f"name={OWN}," in build and f"annotation.{SOURCE}=abc" in build for build in pushed)


def test_no_image_to_write_and_a_plan_without_a_workspace(docker: Docker, plan: Plan, tmp_path: Path) -> None:
    docker.has(images=OWN, size="5")
    keep(carrier(plan, tmp_path), "")
    without = replace(plan, workspace=replace(plan.workspace, ros=None))
    keep(carrier(without, tmp_path), OWN)
    take(carrier(without, tmp_path), (OWN,))
    assert docker.builds() == []


def test_the_source_of_a_tree_is_what_the_compilation_reads(tmp_path: Path) -> None:
    def source(path: str, text: str) -> str:
        with (tmp_path / "repository" / path).open("a") as file:
            file.write(text)
        git = ["git", "-C", str(tmp_path / "repository"), "-c", "user.name=a", "-c", "user.email=a@example.org"]
        for words in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--allow-empty", "-m", "x"]):
            subprocess.run([*git, *words], check=True)
        return source_of(plan_repository(tmp_path / "repository").plan, tmp_path / "repository")

    subprocess.run(["cp", "--recursive", EXAMPLE, tmp_path / "repository"], check=True)
    first = source("README.md", "")
    assert first
    assert source("README.md", "One line more.\n") == first
    assert source("src/talker.cpp", "// again\n") != first
