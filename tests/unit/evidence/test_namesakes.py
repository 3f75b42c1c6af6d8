"""Folders of the tree that are called like a known package."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.python import imports
from roslab.repository.checkout import Repository


def outside(tmp_path: Path, files: dict[str, str]) -> list[str]:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return [each.name for each in imports.read(Repository.open(tmp_path)) if each.namespace == "import"]


@pytest.mark.parametrize(
    ("statement", "found"),
    [
        ("from robomimic.algo import algo_factory", ["robomimic"]),
        ("import robomimic.utils.obs_utils as ObsUtils", ["robomimic"]),
        ("import robomimic", ["robomimic"]),
    ],
)
def test_a_folder_that_lies_in_no_root_is_not_what_is_imported(
    statement: str, found: list[str], tmp_path: Path
) -> None:
    files = {"policy/env/robomimic/wrapper.py": "", "policy/env/__init__.py": "", "policy/run/train.py": statement}
    assert outside(tmp_path, files) == found


@pytest.mark.parametrize(
    ("statement", "found"),
    [
        ("import robomimic", []),
        ("from robomimic.wrapper import Wrapper", []),
        ("from robomimic.made_pb2 import Message", []),
        ("from robomimic.algo import algo_factory", ["robomimic"]),
    ],
)
@pytest.mark.parametrize("root", ["", "policy/", "policy/src/"])
def test_one_in_a_root_is_if_it_has_what_is_named(root: str, statement: str, found: list[str], tmp_path: Path) -> None:
    files = {f"{root}robomimic/wrapper.py": "", "policy/setup.py": "", "run/train.py": f"{statement}\n"}
    assert outside(tmp_path, files) == found


@pytest.mark.parametrize(
    "more",
    [
        {"run/paths.py": 'import sys\nsys.path.append("../outer")\n'},
        {"run.sh": "export PYTHONPATH=$PWD/deep/outer:$PYTHONPATH\n"},
        {"deep/outer/start.py": 'if __name__ == "__main__":\n    main()\n'},
    ],
    ids=["sys.path", "PYTHONPATH", "program"],
)
def test_a_folder_that_is_put_on_the_path_is_a_root(more: dict[str, str], tmp_path: Path) -> None:
    files = {"deep/outer/robomimic/algo.py": "", "run/train.py": "from robomimic.algo import algo_factory\n"}
    assert outside(tmp_path, files) == ["robomimic"]
    assert outside(tmp_path, more) == []


SERIAL = "import {}\nport = {}('/dev/ttyUSB0')\n"


@pytest.mark.parametrize(
    ("code", "found"),
    [
        (SERIAL.format("serial", "serial.Serial"), ["serial"]),
        (SERIAL.format("serial as pyserial", "pyserial.Serial"), ["serial"]),
        (SERIAL.format("time, serial", "serial.Serial"), ["serial"]),
        ("from serial import Serial\n", ["serial"]),
        ("from serial import (\n    Serial,\n    SerialException,\n)\n", ["serial"]),
        ("from serial import driver\n", []),
        ("from serial import *\n", []),
        ("import serial\nimport serial.driver\nserial.driver.start()\n", []),
    ],
)
def test_a_folder_that_is_no_package_hides_none(code: str, found: list[str], tmp_path: Path) -> None:
    page = "export PYTHONPATH=$PYTHONPATH:$(pwd):$(pwd)/serial\n"
    assert outside(tmp_path, {"serial/driver.py": "", "scripts/run.py": code, "setup.sh": page}) == found


@pytest.mark.parametrize("module", ["serial/__init__.py", "serial.py"])
def test_a_package_of_the_tree_is_what_is_imported(module: str, tmp_path: Path) -> None:
    files = {"serial/driver.py": "", module: "", "run.py": SERIAL.format("serial", "serial.Serial")}
    assert outside(tmp_path, files) == []
