"""Versions of pip and JupyterLab that an old Python can still run."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.distros import python_of_ubuntu
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass, replace

INSTALLERS = ("pip", "setuptools", "wheel")
WITHOUT_PKG_RESOURCES = "82"
"""The first setuptools without pkg_resources, which many packages import and few ask for.

https://setuptools.pypa.io/en/latest/history.html#v82-0-0, read 2026-11-26.
"""
NEWEST = ("pip", f"setuptools<{WITHOUT_PKG_RESOURCES}", "wheel")
"""Lines for the newest that serve."""
PIXI = "pixi.toml"
JUPYTER = ("jupyterlab", "notebook", "bash_kernel")


@dataclass(frozen=True, kw_only=True, slots=True)
class PythonTools:
    """Requirement lines of the tools; each pin has a marker, so that it holds only for an interpreter that old."""

    installers: tuple[str, ...] = NEWEST
    jupyter: tuple[str, ...] = JUPYTER
    pinned: bool = False
    """The interpreter is too old for their newest versions."""
    pip_first: bool = False
    """The base's own pip brings a newer one by itself, before the others: it knows neither markers nor a cache."""


OLD_METADATA = "24.1"
"""The first pip that refuses packages whose versions or requirements are not as PEP 440 has them, as many old ones.

https://pip.pypa.io/en/stable/news/#v24-1, read 2026-11-22.
"""
STRICT_SINCE = "2024-06-20"
"""The day of that pip: what somebody installed later by names alone, any pip takes."""


ALWAYS_ISOLATED = "25.3"
"""The first pip that builds even what has only a setup.py apart from all that is installed, torch too.

https://pip.pypa.io/en/stable/news/#v25-3, read 2026-11-23.
"""
ALWAYS_ISOLATED_SINCE = "2025-10-24"
"""The day of that pip. https://pip.pypa.io/en/stable/news/#v25-3, read 2026-11-27."""


def for_old_packages(tools: PythonTools) -> PythonTools:
    """Return the tools with a pip that installs packages with the metadata of their time."""
    return replace(tools, installers=tuple(map(_lenient, tools.installers)))


def with_setuptools(tools: PythonTools, line: str) -> PythonTools:
    """Return the tools with this line in place of those for setuptools."""
    others = (each for each in tools.installers if not each.startswith("setuptools"))
    return replace(tools, installers=(*others, line))


def _lenient(line: str) -> str:
    asked, mark, marker = line.partition(";")
    name, _, below = asked.partition("<")
    if name != "pip" or (below and tuple(map(int, below.split("."))) <= tuple(map(int, OLD_METADATA.split(".")))):
        return line
    return f"pip<{OLD_METADATA}{mark}{marker}"


def why_bounded(line: str) -> str:
    """Return why a requirement line of pip or its companions leaves out more than usual, ``""`` if it does not."""
    pin, _, marker = line.partition(";")
    if (
        "<" not in pin or line in NEWEST or marker.strip().startswith("python_version >=")
    ):  # for a newer Python than the image's alone
        return ""
    if line in {row["pip"] for row in rows("pip_with_sni")}:
        return "newer ones do not reach the index with the image's Python, which has no SNI"
    of_python = {each for tools in _table().values() for each in tools.installers if "<" in each.partition(";")[0]}
    if pin in python2_installers() or line.startswith(tuple(of_python)):
        return "newer ones do not run on the image's Python"
    if pin.startswith("pip<"):
        return "newer ones refuse packages whose versions or requirements are written as in their time"
    return "packages that are built here do not work with newer ones"


@cache
def python2_installers() -> tuple[str, ...]:
    """Return the last installers that run on Python 2.7, whose first pip knows no markers."""
    row = next(row for row in rows("python_tools") if row["python"] == "2.7")
    return tuple(row[name] for name in INSTALLERS)


@cache
def tool_image(tool: str) -> str:
    """Return the image that a program is copied from, with its tag."""
    return next(row["image"] for row in rows("tool_images") if row["tool"] == tool)


@cache
def _table() -> dict[str, PythonTools]:
    return {
        row["python"]: PythonTools(
            installers=_lines(row, INSTALLERS), jupyter=(*_lines(row, JUPYTER), *_beside(row)), pinned=True
        )
        for row in rows("python_tools")
    }


def _lines(row: dict[str, str], names: tuple[str, ...]) -> tuple[str, ...]:
    major, minor = map(int, row["python"].split("."))
    after = f"{major}.{minor + 1}"
    lines: list[str] = []
    newest = dict(zip(INSTALLERS, NEWEST, strict=True))
    for name in names:
        if pin := row[name]:
            lines += [f'{pin}; python_version < "{after}"', f'{newest.get(name, name)}; python_version >= "{after}"']
        else:
            lines.append(name)
    return tuple(lines)


def _beside(row: dict[str, str]) -> tuple[str, ...]:
    """Return pins of JupyterLab's dependencies that it does not bound: newer ones have no wheel for that Python."""
    major, minor = map(int, row["python"].split("."))
    return tuple(f'{pin}; python_version < "{major}.{minor + 1}"' for pin in row["beside"].split())


def python_tools(version: str | None, ubuntu: str | None) -> PythonTools:
    """Return the tools for a Python version, or for an Ubuntu's own Python where no version is given."""
    known = version or python_of_ubuntu().get(ubuntu or "", "3.12")
    tools = _table().get(".".join(known.split(".")[:2]), PythonTools())
    first = pip_with_sni(ubuntu) if known.startswith("2") else None
    if first is None:
        return tools
    others = (each for each in tools.installers if not each.startswith("pip"))
    return replace(tools, installers=(first[0], *others), pip_first=True)


def pip_with_sni(ubuntu: str | None) -> tuple[str, tuple[str, ...]] | None:
    """Return the pip that reaches its index on an Ubuntu whose Python 2 does not, with what apt brings for that.

    The base's own pip, which brings it, knows no markers and no cache. ``None`` for all other Ubuntus.
    """
    found = next((row for row in rows("pip_with_sni") if row["ubuntu"] == ubuntu), None)
    return (found["pip"], tuple(found["apt"].split())) if found else None
