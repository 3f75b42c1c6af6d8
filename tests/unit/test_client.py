"""A docker client's folder of its own: what goes in, and who may read it."""

from __future__ import annotations

import stat
from pathlib import Path

import pytest

from roslab.engine.client import login, private_client
from roslab.errors import BuildError

DOCKER = """#!/bin/sh
# A stand-in for docker's client: it records what it was given, and refuses one password
cat > "$DOCKER_CONFIG/given"
echo "$*" > "$DOCKER_CONFIG/words"
if grep -q wrong "$DOCKER_CONFIG/given"; then echo "Error: unauthorized: incorrect username or password" >&2; exit 1; fi
"""


def test_a_login_goes_through_standard_input(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "docker").write_text(DOCKER)
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    login(tmp_path, "docker.io", "robot", "hidden")
    assert (tmp_path / "given").read_text() == "hidden"
    assert (tmp_path / "words").read_text().split() == ["login", "docker.io", "--username", "robot", "--password-stdin"]
    with pytest.raises(BuildError, match=r"docker.io refuses the login for base images: .*incorrect username") as told:
        login(tmp_path, "docker.io", "robot", "wrong")
    assert "wrong" not in str(told.value)


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
