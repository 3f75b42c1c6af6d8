"""Secrets on this machine: where they are, how BuildKit gets them, and what is said of one that is missing."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.engine.secrets import of_environment
from roslab.errors import ConfigurationError


def words(names: tuple[str, ...], environment: dict[str, str]) -> list[list[str]]:
    return [secret.words() for secret in of_environment(names, environment)]


def test_a_variable_a_file_and_an_agent(tmp_path: Path) -> None:
    (tmp_path / ".netrc").touch()
    (tmp_path / 'a,"b').touch()
    environment = {
        "HOME": str(tmp_path),
        "SSH_AUTH_SOCK": "/run/agent",
        "PIP_INDEX": "https://user:hidden@example.org/simple",
        "MAP_KEY_FILE": str(tmp_path / 'a,"b'),
    }
    assert words(("pip_index", "netrc", "ssh", "map-key"), environment) == [
        ["--secret", "id=pip_index,env=PIP_INDEX"],
        ["--secret", f'id=netrc,"src={tmp_path}/.netrc"'],
        ["--ssh", "default"],
        ["--secret", f'id=map-key,"src={tmp_path}/a,""b"'],
    ]


def test_every_missing_one_is_told_with_how_to_give_it(tmp_path: Path) -> None:
    with pytest.raises(ConfigurationError) as caught:
        of_environment(("pip_index", "netrc", "ssh"), {"HOME": str(tmp_path), "PIP_INDEX_FILE": "/nowhere"})
    said = str(caught.value).splitlines()
    assert "secret pip_index" in said[0]
    assert "PIP_INDEX_FILE" in said[0]
    assert f"there is no file {tmp_path}/.netrc" in said[1]
    assert "ssh-add" in said[2]
