"""The lock of a published image: of all its platforms, named by the index, and fetched by one line of the summary."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.errors import ConfigurationError
from roslab.github import kept, locking
from roslab.github.run import Folder, Run, slug, to_line
from roslab.pipeline import plan_repository
from roslab.plan.lock import digest, from_text, to_text
from roslab.plan.locked import Lock, LockedSource, Machine, Package

PLATFORMS = ("linux/amd64", "linux/arm64")


@pytest.fixture
def folder(tmp_path: Path, examples: Path) -> Folder:
    plan = replace(plan_repository(examples / "python_filter").plan, platforms=PLATFORMS)
    folder = Folder.new({"RUNNER_TEMP": str(tmp_path)})
    folder.artifact.mkdir()
    run = Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=True, reason="why", cache="auto", lock=True)
    folder.write("run", to_line(run))
    return folder


def part(platform: str, *names: str) -> str:
    apt = Package(name="robot", version="1.0", architecture="all", source="robot", origin="", step="packages")
    return to_text(
        Lock(
            base="ubuntu:24.04",
            digest="sha256:" + "a" * 64,
            python="venv",
            rosdistro=None,
            tools=(("roslab", "1"),),
            sources=tuple(LockedSource(name=n, url=f"https://example.org/{n}.git", commit="1" * 40) for n in names),
            machines=(Machine(platform=platform, apt=(apt,), python=(), conda=()),),
        )
    )


def write(folder: Folder, platform: str, text: str, attempt: int = 1) -> None:
    place = folder.artifact / f"image-{slug(platform)}-{attempt}"
    kept.begin(place, platform=platform, attempt=attempt)
    (place / f"lock-{slug(platform)}.json").write_text(text)


def test_the_parts_of_all_platforms_make_one_lock(folder: Folder, tmp_path: Path) -> None:
    for platform, names in zip(PLATFORMS, (("b", "a"), ("a",)), strict=True):
        write(folder, platform, part(platform, *names))
    environment = {"GITHUB_OUTPUT": str(tmp_path / "outputs"), "GITHUB_RUN_ATTEMPT": "2"}
    annotated = locking.kept(folder, folder.artifact, environment)
    text = folder.read("roslab.lock")
    assert annotated == {locking.ANNOTATION: digest(text)}
    lock = from_text(text)
    assert [each.platform for each in lock.machines] == list(PLATFORMS)
    assert [each.name for each in lock.sources] == ["a", "b"]
    outputs = (tmp_path / "outputs").read_text()
    assert str(folder.path / "roslab.lock") in outputs
    assert folder.read("lock-artifact").startswith("lock-lab-robot-")
    assert folder.read("lock-artifact").endswith("-2")


def test_a_platform_without_a_lock_leaves_none(folder: Folder, tmp_path: Path) -> None:
    write(folder, PLATFORMS[0], part(PLATFORMS[0]))
    environment = {"GITHUB_OUTPUT": str(tmp_path / "outputs")}
    assert locking.kept(folder, folder.artifact, environment) == {}
    assert not (tmp_path / "outputs").exists()


def test_a_run_that_was_not_asked_for_a_lock_keeps_none(folder: Folder) -> None:
    for platform in PLATFORMS:
        write(folder, platform, part(platform))
    folder.write("run", to_line(replace(folder.run, lock=False)))
    assert locking.kept(folder, folder.artifact, {}) == {}


def test_a_file_that_is_no_lock_is_refused(folder: Folder) -> None:
    for platform in PLATFORMS:
        write(folder, platform, '{"version": 1, "base": "$(reboot)"}')
    with pytest.raises(ConfigurationError):
        locking.kept(folder, folder.artifact, {})


def test_of_a_platform_that_was_run_again_the_newest_attempt_counts(folder: Folder) -> None:
    for attempt, name in ((9, "old"), (10, "new")):
        write(folder, PLATFORMS[0], part(PLATFORMS[0], name), attempt)
    write(folder, PLATFORMS[1], part(PLATFORMS[1]))
    text = locking.gathered(folder.artifact, folder.run)
    assert [each.name for each in from_text(text).sources] == ["new"]
