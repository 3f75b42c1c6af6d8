"""A docker client's folder of its own: what goes in, and who may read it."""

from __future__ import annotations

import stat
from pathlib import Path

from roslab.engine.client import private_client


def test_a_login_of_before_goes_on_and_the_builder_in_use_does_not(tmp_path: Path) -> None:
    own = tmp_path / "own"
    for file in ("config.json", "contexts/meta/a/meta.json", "cli-plugins/docker-buildx", "buildx/current"):
        (own / file).parent.mkdir(parents=True, exist_ok=True)
        (own / file).write_text(file)
    made = private_client(tmp_path / "home", {"DOCKER_CONFIG": str(own)})
    assert made == tmp_path / "home/.docker"
    assert {str(path.relative_to(made)) for path in made.rglob("*") if path.is_file()} == {
        "config.json", "contexts/meta/a/meta.json", "cli-plugins/docker-buildx",
    }  # fmt: skip
    assert stat.S_IMODE(made.stat().st_mode) == 0o700
    assert stat.S_IMODE((made / "config.json").stat().st_mode) == 0o600


def test_by_default_the_users_own_and_none_is_none(tmp_path: Path) -> None:
    (tmp_path / ".docker").mkdir()
    (tmp_path / ".docker/config.json").write_text("{}")
    assert (private_client(tmp_path / "a", {"HOME": str(tmp_path)}) / "config.json").read_text() == "{}"
    assert list(private_client(tmp_path / "b", {}).iterdir()) == []
