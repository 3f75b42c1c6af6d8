"""Wrong files with the message that each gets; REPRO_REFRESH=1 writes the messages anew, and the diff is read."""

import os
import pathlib

import pytest

from roslab.config import read
from roslab.errors import ConfigurationError

FOLDER = pathlib.Path(__file__).resolve().parent
FILES = sorted(FOLDER.glob("*.yaml"))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_message(file: pathlib.Path) -> None:
    with pytest.raises(ConfigurationError) as caught:
        read(file.read_bytes())
    told = f"{caught.value}\n"
    expected = file.with_suffix(".expected")
    if os.environ.get("REPRO_REFRESH"):
        expected.write_text(told, encoding="utf-8")
    assert told == expected.read_text(encoding="utf-8")


def test_each_message_has_its_file() -> None:
    assert {file.stem for file in FOLDER.glob("*.expected")} == {file.stem for file in FILES}
