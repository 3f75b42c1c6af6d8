"""The keys of package sources: each is the one that its row names, and still valid when the table was read."""

from __future__ import annotations

import datetime as dt
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.knowledge import keys
from roslab.knowledge.table import rows


@pytest.mark.parametrize("row", rows("keys"), ids=lambda row: row["name"])
def test_a_key_is_the_one_that_its_row_names(row: dict[str, str], tool: Callable[[str], str], tmp_path: Path) -> None:
    command = [tool("gpg"), "--homedir", str(tmp_path), "--batch", "--show-keys", "--with-colons"]
    tmp_path.chmod(0o700)
    shown = subprocess.run(command, input=keys.key(row["name"]), capture_output=True, text=True, check=True).stdout
    fields = [line.split(":") for line in shown.splitlines()]
    primary = next(line for line in fields if line[0] == "pub")
    assert next(line[9] for line in fields if line[0] == "fpr") == row["fingerprint"]
    assert dt.datetime.fromtimestamp(int(primary[6]), dt.timezone.utc).date().isoformat() == row["expires"]
    assert row["expires"] > row["date"]


def test_every_package_source_of_ros_has_its_key() -> None:
    assert {row["key"] for row in rows("ros_packages")} <= {row["name"] for row in rows("keys")}


def test_a_name_without_a_row_is_no_key() -> None:
    with pytest.raises(KeyError):
        keys.key("../ubuntu")
