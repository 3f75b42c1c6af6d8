"""Versions of pip and JupyterLab that an old Python can still run."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from importlib.resources import files


@dataclass(frozen=True, kw_only=True, slots=True)
class PythonTools:
    """Requirement lines of the tools, the newest where a Python is young enough."""

    pip: str = "pip"
    setuptools: str = "setuptools"
    wheel: str = "wheel"
    jupyterlab: str = "jupyterlab"
    notebook: str = "notebook"
    bash_kernel: str = "bash_kernel"


SYSTEM_PYTHON = {
    "trusty": "3.4",
    "xenial": "3.5",
    "bionic": "3.6",
    "focal": "3.8",
    "jammy": "3.10",
    "noble": "3.12",
    "resolute": "3.14",
}
"""``python3`` of each Ubuntu. https://packages.ubuntu.com/python3, read 2026-08-22."""


@cache
def _table() -> dict[str, PythonTools]:
    with files("roslab.knowledge").joinpath("python_tools.csv").open(encoding="utf-8", newline="") as stream:
        rows = csv.DictReader(stream)
        return {
            row["python"]: PythonTools(
                **{key: value for key in PythonTools.__dataclass_fields__ if (value := row[key])}
            )
            for row in rows
        }


def python_tools(version: str | None, ubuntu: str | None) -> PythonTools:
    """Return the tools for a Python version, or for an Ubuntu's own Python where no version is given."""
    known = version or SYSTEM_PYTHON.get(ubuntu or "", "3.12")
    return _table().get(".".join(known.split(".")[:2]), PythonTools())
