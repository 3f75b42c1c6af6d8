"""How pages write the release of Ubuntu that the code is for."""

from __future__ import annotations

import pytest

from roslab.evidence.prose.mentions import read


def named(text: str) -> list[str]:
    return [m.value for m in read(text, "README.md", "readme") if m.topic == "ubuntu"]


@pytest.mark.parametrize(
    "text",
    [
        "Ubuntu 20.04",
        "Ubuntu20.04LTS",
        "ubuntu-20.04x64",
        "Ubuntu (20.04)",
        "Ubuntu version: 20.04",
        "Ubuntu Desktop 20.04",
        "| Ubuntu | 20.04 |",
        "Ubuntu\u7248\u672c\uff1a20.04",
        "Ubuntu\uff0820.04\uff09",
    ],
)
def test_a_release_is_named(text: str) -> None:
    assert named(text) == ["20.04"]


@pytest.mark.parametrize(
    "text",
    ["Ubuntu (20 cores)", "| Ubuntu | 16 | 32 GB |", "Ubuntu 20.04lists", "Ubuntu or 20.04", "Ubuntu | 3 | 20.04"],
)
def test_other_numbers_name_none(text: str) -> None:
    assert not named(text)
