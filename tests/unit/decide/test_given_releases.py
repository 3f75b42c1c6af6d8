"""Releases that roslab.yaml names under ``pip`` win over what lists and projects pin."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from trees import tree_of

SETUP = """\
from setuptools import setup

setup(name="robot", py_modules=["robot"], install_requires=["six==1.99", "attrs"])
"""


@pytest.mark.parametrize(
    ("given", "listed", "gives_way"),
    [
        ("six==1.17.0", "six==1.99", True),
        ("six<1.17", "six==1.17.0", True),
        ("six==1.10.0", "six>=1.12", True),
        ("six==1.17.0", "six>=1.12", False),
        ("six<2", "six", False),
        ("six==1.17.0", "six==1.17.0", False),
        ("six<1.17", "six>=1.12", False),
        ("six", "six==1.99", False),
        ("attrs<20", "six==1.99", False),
    ],
)
def test_a_list_gives_way_where_both_cannot_be(tmp_path: Path, given: str, listed: str, gives_way: bool) -> None:
    config = f'format: 3\nkind: python\npip: ["{given}"]\n'
    tree_of(tmp_path, {"requirements.txt": f"attrs\n{listed}\n", "main.py": "import six\n", "roslab.yaml": config})
    plan = plan_repository(tmp_path).plan
    assert plan.python.requirements == (() if gives_way else ("requirements.txt",))
    assert plan.python.pip == ((given, "attrs", "six") if gives_way else (given,))
    told = [f"{each.file}:{each.line}" for each in plan.warnings if " gives way to " in each.message]
    assert told == (["requirements.txt:2"] if gives_way else [])


def test_so_does_a_project(tmp_path: Path) -> None:
    config = "format: 3\nkind: python\npip: [six==1.17.0]\n"
    tree_of(tmp_path, {"setup.py": SETUP, "robot.py": "import six\n", "roslab.yaml": config})
    plan = plan_repository(tmp_path).plan
    assert plan.python.pip == ("six==1.17.0", "six", "attrs")
    assert plan.python.alone == (".",)
    told = "six==1.99 gives way to six==1.17.0, which `pip` in roslab.yaml names"
    assert told in [each.message for each in plan.warnings]


@pytest.mark.parametrize(
    ("lines", "left", "told"),
    [
        ("flask==1.1.2\nwerkzeug==2.2.3\n", "werkzeug", True),
        ("flask<1.1.3\nwerkzeug==2.2.3\n", "werkzeug", True),
        ("flask==1.1.2\nwerkzeug==2.0.3\n", "", False),
        ("flask==2.2.0\nwerkzeug==2.2.3\n", "", False),
        ("flask\nwerkzeug==2.2.3\n", "", False),
        ("flask==1.1.2\nwerkzeug>=2.1\n", "", False),  # a bound that somebody thought of
        ("flask==1.1.2; python_version < '3.9'\nwerkzeug==2.2.3\n", "", False),
        ("pandas==2.0.3\nnumpy==2.0.1\n", "numpy", True),
        ("pandas==2.2.2\nnumpy==2.0.1\n", "", False),
        ("pandas==2.0.3\nnumpy==2.0.1\nopencv-python==4.12.0.88\n", "", False),  # no NumPy is for both
    ],
)
def test_a_pin_gives_way_to_one_that_stops_beside_it(tmp_path: Path, lines: str, left: str, *, told: bool) -> None:
    tree_of(tmp_path, {"requirements.txt": f"attrs\n{lines}", "main.py": "import attrs\n", ".python-version": "3.10\n"})
    plan = plan_repository(tmp_path).plan
    assert plan.python.requirements == (() if left else ("requirements.txt",))
    assert left in {"", *plan.python.pip}
    assert any(each.startswith(f"{left}<") for each in plan.python.bounds) == bool(left) or not left
    warned = [f"{each.file}:{each.line}" for each in plan.warnings if " gives way to " in each.message]
    assert warned == (["requirements.txt:3"] if told else [])


def test_pins_of_a_long_list_are_looked_at_once(tmp_path: Path) -> None:
    lines = "".join(f"pandas==2.0.{each}\nnumpy==2.0.{each}\n" for each in range(300))
    tree_of(tmp_path, {"requirements.txt": lines, "main.py": "import numpy\n", ".python-version": "3.10\n"})
    started = time.process_time()
    plan = plan_repository(tmp_path).plan
    assert time.process_time() - started < 5
    assert len([each for each in plan.warnings if " gives way to numpy<2" in each.message]) == 300


def test_so_does_one_of_a_project(tmp_path: Path) -> None:
    setup = SETUP.replace('"six==1.99", "attrs"', '"jinja2==2.11.3", "markupsafe==2.1.1"')
    tree_of(tmp_path, {"setup.py": setup, "robot.py": "import jinja2\n"})
    plan = plan_repository(tmp_path).plan
    assert plan.python.pip == ("jinja2==2.11.3", "markupsafe")
    assert plan.python.alone == (".",)
    assert "markupsafe<2.1" in plan.python.bounds
