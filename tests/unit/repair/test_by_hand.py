"""A value that somebody wrote is never exchanged by a repair; one that a repair set before may be."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.repair.chain import Asking, proposed
from roslab.repair.change import Change
from roslab.values.dataclass import replace
from trees import tree_of

GONE = "#6 [3/4] RUN pip install x\n#6 9.0 ModuleNotFoundError: No module named 'imp'\n#6 ERROR: process did not: 1\n"
OLD = """\
#6 [3/4] RUN cmake .
#6 9.0 CMake Error at CMakeLists.txt:1 (cmake_minimum_required):
#6 9.0   CMake 3.22 or higher is required.  You are running version 3.16.3
#6 ERROR: process "/bin/sh -c cmake ." did not complete successfully: exit code: 1
"""
WHEEL = """\
#6 [3/4] RUN pip install -r a.txt
#6 9.0 Downloading fast-robot-2.0.tar.gz
#6 9.0 Failed to build fast-robot
#6 ERROR: process "/bin/sh -c pip install -r a.txt" did not complete successfully: exit code: 1
"""
DISPLAY = "_tkinter.TclError: no display name and no $DISPLAY environment variable\n"
MODULE = """\
Traceback (most recent call last):
  File "/home/jovyan/robot/main.py", line 1, in <module>
ModuleNotFoundError: No module named 'grips'
"""
FILES = {"main.py": "import fast_robot\n", "requirements.txt": "fast-robot==2.0\n", "grip/grips.py": "print(1)\n"}


def changed(folder: Path, config: str, log: str, *added: str) -> Change:
    tree_of(folder / "robot", {**FILES, "roslab.yaml": f"format: 3\nkind: python\n{config}"})
    known = replace(given(plan_repository(folder / "robot")), added=frozenset(added))
    asking = Asking(wheels=lambda _: "fast-robot 3.9\n")
    (change,) = proposed(explain(io.BytesIO(log.encode())), known, asking=asking).changes
    return change


@pytest.mark.parametrize(
    ("config", "log", "key", "said"),
    [
        ("base: {python: '3.12'}\n", GONE, "base.python", "3.12 becomes 3.11"),
        ("base: {python: '3.11'}\n", WHEEL, "base.python", "3.11 becomes 3.9"),
        ("base: {cmake_update: 3.20.0}\n", OLD, "base.cmake_update", "3.20.0 becomes 3.22.0"),
        ("gui: false\n", DISPLAY, "gui", "false becomes true"),
    ],
)
def test_it_is_told_what_would_do_and_who_has_to_write_it(
    tmp_path: Path, config: str, log: str, key: str, said: str
) -> None:
    change = changed(tmp_path, config, log)
    assert not change.certain
    assert str(change) == f"{key}: {said}"
    assert change.told.endswith(f" says {said.split(maxsplit=1)[0]}, which is yours to exchange")
    assert "; roslab.yaml:3:" in change.told


@pytest.mark.parametrize(("config", "log"), [("base: {python: '3.12'}\n", GONE), ("gui: false\n", DISPLAY)])
def test_what_a_repair_set_a_repair_exchanges(tmp_path: Path, config: str, log: str) -> None:
    assert changed(tmp_path, config, log, "base.python", "gui").certain


def test_a_path_is_added_to(tmp_path: Path) -> None:
    change = changed(tmp_path, "env: {PYTHONPATH: /opt/arm}\n", MODULE)
    assert (change.key, change.certain) == ("env.PYTHONPATH", True)
    assert change.value.endswith("/grip:/opt/arm")
