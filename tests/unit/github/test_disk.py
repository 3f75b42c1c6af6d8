"""Room is made on a runner of GitHub's own, as far as it is needed, and what is removed is listed."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from roslab.engine import disk as engine_disk
from roslab.github import disk
from roslab.knowledge.runner_weight import runner_weight

TOTAL = 100 * disk.GB


@pytest.fixture
def runner(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder whose files are what fills the disk: a byte stands for a gigabyte."""

    def free() -> int:
        return TOTAL - disk.GB * sum(file.stat().st_size for file in tmp_path.rglob("*") if file.is_file())

    monkeypatch.setattr(engine_disk, "free", free)
    for name, size in (("android", 40), ("dotnet", 30), ("swift", 20)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "file").write_bytes(b"x" * size)
    return tmp_path


def weights(runner: Path) -> list[tuple[str, str]]:
    return [(str(runner / name), name) for name in ("android", "absent", "dotnet", "swift")]


def test_only_as_much_as_is_needed(runner: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert disk.make_room(60 * disk.GB, weights(runner)) == 80 * disk.GB
    assert sorted(path.name for path in runner.iterdir()) == ["swift"]
    told = capsys.readouterr().err
    assert f"removed {runner}/android (android): 40.0 GB more, 50.0 GB free" in told
    assert "absent" not in told


def test_a_link_is_left_alone(runner: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    (elsewhere / "kept").touch()
    shutil.rmtree(runner / "android")
    (runner / "android").symlink_to(elsewhere)
    disk.make_room(99 * disk.GB, weights(runner))
    assert (elsewhere / "kept").exists()


def test_nothing_is_removed_that_an_image_or_a_step_needs() -> None:
    for path, _ in runner_weight():
        assert path.count("/") >= 2
        assert not path.startswith(("/opt/hostedtoolcache/Python", "/usr/bin", "/usr/lib", "/home", "/var"))


def test_a_layer_that_is_nearly_too_large_for_ghcr_is_told_before_it_is() -> None:
    layers = [(7_900_000_000, "RUN small"), (8_400_000_000, "RUN pip install torch")]
    (problem,) = disk.large_layers("ghcr.io/somebody/paper", layers)
    assert "a layer of 8.4 GB is near the 10.0 GB that ghcr.io takes: RUN pip install torch" in problem.message
    assert disk.large_layers("registry.example.org/somebody/paper", layers) == ()
