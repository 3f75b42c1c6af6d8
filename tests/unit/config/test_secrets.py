"""``secrets`` of roslab.yaml: names alone, and what an address of ssh means beside them."""

from __future__ import annotations

import pytest

from roslab.config import read
from roslab.config.written import written
from roslab.errors import ConfigurationError

SOURCE = "source: [{name: a, repo: 'git@example.org:lab/a.git'}]\n"


def refused(text: str) -> str:
    with pytest.raises(ConfigurationError) as caught:
        read(text)
    return str(caught.value)


def test_names_in_the_order_of_the_file() -> None:
    config = read("format: 3\nsecrets: [pip_index, netrc, pip_index, MAP-key]\n")
    assert config.secrets == ("pip_index", "netrc", "MAP-key")
    assert str(config.origin("secrets.1")) == "roslab.yaml:2:22"
    assert read(written(config)).secrets == config.secrets
    assert read("format: 3\n").secrets == ()


@pytest.mark.parametrize(
    "name", ["'https://user:password@index'", "a=b", "'a,env=PATH'", "../netrc", "docker.io", "''", "1a", "'a b'"]
)
def test_a_value_or_a_path_is_no_name(name: str) -> None:
    assert "is no name of a secret" in refused(f"format: 3\nsecrets: [{name}]\n")


def test_two_names_of_one_variable() -> None:
    assert "secrets: two are named MAP_KEY in the environment, map-key and MAP_KEY" in refused(
        "format: 3\nsecrets: [map-key, MAP_KEY]\n"
    )


def test_an_address_of_ssh_stays_where_the_build_has_a_key() -> None:
    config = read(f"format: 3\nsecrets: [ssh]\n{SOURCE}")
    assert config.source[0].repo == "git@example.org:lab/a.git"
    assert config.warnings == ()
    assert "`secrets: [ssh]`" in refused(f"format: 3\n{SOURCE}")
    assert read(f"format: 3\n{SOURCE.replace('example.org', 'github.com')}").source[0].repo == (
        "https://github.com/lab/a.git"
    )
