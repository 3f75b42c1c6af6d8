"""Whose a failure is, by a rule on its log: ours or the code's, the stand-in's, or what a program was not given."""

from __future__ import annotations

import io
import re
import subprocess
import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from benchmarks.running.rows import Whose
from roslab.explain.answer import Explanation, explain
from roslab.knowledge.code_limits import bounds_of, version_of
from roslab.knowledge.distros import cmake_of_ubuntu, python_of_ubuntu
from roslab.knowledge.frameworks import framework
from roslab.knowledge.released import released, rosdep_keys
from roslab.values.version import minor_of
from roslab.values.version import version_of as parsed

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

HERE = Path(__file__).resolve().parent
LABEL = "org.repro-action.stand-in"
"""The label by which an image says that it stands in for another."""
ASKED = re.compile(
    r"""package(?:s|\ configuration\ file\ provided\ by)?\ ['"\[]([a-z]\w+)
    |node\ of\ type\ \[([a-z]\w+)/ | [ ]([a-z]\w+)/\w+\.h(?:pp)?:\ No\ such\ file
    |No\ module\ named\ '([a-z]\w+) | Resource\ not\ found:\ ([a-z]\w+)""",
    re.VERBOSE,
)
"""Names of ROS packages in what catkin, the compiler, Python and roslaunch say of one that is not there."""

LEFT_OUT = re.compile(r"roslab: left out: apt ros-[a-z]+-([a-z0-9-]+)\s*$", re.MULTILINE)
"""A package of ROS that the base does not know, as the image's own script tells it."""
ALONE = re.compile(r"Cannot install ([\w.-]+)==([\w.]+) because these package versions have conflicting dependencies")
"""What pip says where one package alone conflicts with itself: it finds none."""
COLOUR = re.compile(r"\x1b\[[0-9;]*m")


@dataclass(frozen=True, kw_only=True)
class Base:
    """What a plan's base image is, and what really was below its name."""

    name: str
    ubuntu: str | None
    """Code name of the Ubuntu that the plan takes."""
    python: str | None
    """The plan's Python."""
    stand_in: str = ""
    """``Debian 12``; ``""`` if it is the real image."""
    lacking: frozenset[str] = frozenset()
    """ROS packages and keys of rosdep that the world has and the stand-in does not."""


@cache
def facts() -> dict[str, Any]:
    """Return what the stand-ins are known to lack."""
    return tomllib.loads((HERE / "standins.toml").read_text(encoding="utf-8"))


def of_build(log: str, base: Base) -> tuple[Whose, str, str]:
    """Return whose the failure of a build is, its id and why in one line."""
    found = explain(io.BytesIO(log.encode("utf-8", errors="replace"))).explanations
    if not found:
        return "unclear", "", "the build failed without a step that failed"
    first = found[0]
    return _whose(first, log, base), first.id or "", _why(first)


def of_run(output: str, base: Base) -> tuple[Whose, str, str]:
    """Return why a command that was built did not run on, from what it printed."""
    found = explain(io.BytesIO(output.encode("utf-8", errors="replace"))).explanations
    first = found[0] if found else Explanation(step="")
    said = _why(first) if first.id else _last(output)
    whose = _whose(first, output, base)
    if whose == "stand-in":
        return whose, first.id or "", said if first.id else _lacked(output, base) or said
    for row in facts()["needs"]:
        if asked := re.search(row["pattern"], output):
            line = output[output.rfind("\n", 0, asked.start()) + 1 :].partition("\n")[0].strip()
            return "needs", first.id or "", f"it was given no {row['what'].removeprefix('a ')}: {line[:200]}"
    return whose, first.id or "", said


def is_base(cause: str) -> bool:
    """Tell whether a known failure means that an image is out of reach."""
    return cause in facts()["base"]["ids"]


def _whose(found: Explanation, log: str, base: Base) -> Whose:
    """Return whose a failure is; every rule of the stand-in needs a stand-in."""
    if base.stand_in:
        known = facts()
        if found.id in (*known["network"]["ids"], *known["base"]["ids"]):
            return "stand-in"
        if "cuda" in base.name and found.id in known["cuda"]["ids"]:
            return "stand-in"
        said = "\n".join((found.error, *found.lines)) or log[-4000:]
        names = {name for _, value in found.names for name in value.split(", ")}
        if (_asked(said) | names) & (base.lacking | _lacks(base)) or {*map(_bare, names)} & _left_out(log, base):
            return "stand-in"
        of_python = (found.id in known["python"]["ids"] and _python_is_another(base)) or _no_wheel(said, base)
        if of_python or (found.id in known["release"]["ids"] and _asks_for_the_plans(dict(found.names), base)):
            return "stand-in"
        had_wheel = found.id in known["wheels"]["ids"] and _had_wheel(log, names, base)
        told = f"{said}\n{found.log}"
        if had_wheel or any(_between(row, base) and re.search(row["pattern"], told) for row in known["change"]):
            return "stand-in"
    return "ours or the code's" if found.id or found.error else "unclear"


def _lacks(base: Base) -> frozenset[str]:
    """Return what the world has of the ROS packages that the stand-in has for its table alone."""
    distro = base.name.removeprefix("ros:").partition("-")[0] if base.name.startswith("ros:") else ""
    return released(distro) & frozenset(facts()["lacks"].get(base.stand_in, ()))


def _python_is_another(base: Base) -> bool:
    return base.python is not None and not facts()["versions"][base.stand_in]["python"].startswith(base.python)


def _no_wheel(said: str, base: Base) -> bool:
    """Tell whether pip has no release of a framework for the stand-in's Python, and one for the plan's.

    What else asks for it, be it a constraint of the same number, makes it a conflict to pip.
    """
    asked = ALONE.search(said)
    row = framework(asked[1], asked[2]) if asked else None
    there = minor_of(facts()["versions"][base.stand_in]["python"])
    return bool(row and base.python and there and row.runs_with(base.python) and not row.runs_with(there))


def _asks_for_the_plans(names: Mapping[str, str], base: Base) -> bool:
    """Tell whether CMake asks for a release of a library that the plan's base has, and the stand-in has not."""
    library, asked = names.get("name", ""), names.get("version", "")
    there = facts()["versions"].get(base.stand_in, {}).get(library)
    real, now, wanted = (parsed(text) if text else None for text in (_of_plan(library, base), there, asked))
    if not (real and now and wanted):
        return False
    least, below = (parsed(text) if text else None for text in bounds_of(library, asked))
    fits = [bool(least and least <= each and not (below and each >= below)) for each in (real, now)]
    return fits == [True, False]


def _had_wheel(log: str, names: set[str], base: Base) -> bool:
    """Tell whether a release that pip compiled, and could not, has a wheel for the plan's Python, not the stand-in's.

    ``names`` are those of the failure; the release is that of the archive of sources which the log names.
    """
    here = ".".join(facts()["versions"][base.stand_in]["python"].split(".")[:2])
    for row in facts()["wheel"]:
        first = {python: parsed(release) for python, release in row["first"].items()}
        begun, ended = first.get(base.python or ""), first.get(here)
        if row["package"] not in names or not begun or not ended:
            continue
        found = re.findall(rf"\b{re.escape(row['package'])}-(\d+(?:\.\d+)+)\.(?:tar\.gz|zip)\b", log)
        if any((release := parsed(text)) and begun <= release < ended for text in found):
            return True
    return False


def _between(change: Mapping[str, str], base: Base) -> bool:
    """Tell whether a library changed between the plan's release of it and the stand-in's, the older of the two.

    Where the row says so (``lacks``), the stand-in has the older one, without what came with the change.
    """
    there = facts()["versions"].get(base.stand_in, {}).get(change["library"])
    named = _of_plan(change["library"], base)
    real, now, since = (parsed(text) if text else None for text in (named, there, change["since"]))
    if change.get("lacks"):
        real, now = now, real
    return bool(real and now and since and real < since <= now)


def _of_plan(library: str, base: Base) -> str | None:
    if base.ubuntu is None:
        return base.python if library == "python" else None
    if library == "python":
        # Nodes of ROS 1 before noetic run with Python 2, whatever else is there
        old = base.name.startswith("ros:") and base.ubuntu in ("trusty", "xenial", "bionic")
        return "2.7" if old else base.python or python_of_ubuntu().get(base.ubuntu)
    if library == "cmake":
        return cmake_of_ubuntu().get(base.ubuntu)
    if older := facts()["older"].get(library):
        found: str | None = older.get(base.ubuntu)
        return found
    return version_of(library, base.ubuntu, ros=base.name.startswith("ros:"))


def _why(found: Explanation) -> str:
    said = found.cause or found.error or (found.lines[-1] if found.lines else "no known cause")
    return f"{said}: {found.error}"[:300] if found.cause and found.error else said[:300]


def _asked(text: str) -> set[str]:
    return {name for match in ASKED.finditer(text) for name in match.groups() if name}


def _left_out(log: str, base: Base) -> set[str]:
    """Return the bare names of libraries whose packages the build left out, and that the stand-in alone lacks."""
    names = (match[1].replace("-", "_") for match in LEFT_OUT.finditer(log))
    return {_bare(name) for name in names if name in base.lacking}


def _bare(name: str) -> str:
    return name.lower().removeprefix("lib")


def _lacked(output: str, base: Base) -> str:
    """Return the first line that asks for something that only the stand-in lacks."""
    return next((line for line in _lines(output) if _asked(line) & base.lacking), "")


def _last(output: str) -> str:
    return next(reversed(_lines(output)), "it said nothing")


def _lines(output: str) -> list[str]:
    """Return the lines with something on them, without colours."""
    return [line.strip()[:300] for line in COLOUR.sub("", output).splitlines() if line.strip()]


def stand_in(image: str) -> str:
    """Return what stands in for an image of the engine, ``""`` if it is the real one."""
    said = _output("docker", "image", "inspect", "--format", f'{{{{index .Config.Labels "{LABEL}"}}}}', image)
    return said.partition(" in the place")[0].strip()


def lacking(image: str, distro: str | None) -> frozenset[str]:
    """Return the ROS packages and keys of rosdep that the world has and this stand-in's tables do not."""
    if not distro:
        return frozenset()
    return (released(distro) | rosdep_keys()) - {name for text in _tables(image, distro) for name in _names(text)}


def _tables(image: str, distro: str) -> Iterable[str]:
    for name in ("stand-in", distro):
        yield _output("docker", "run", "--rm", "--entrypoint", "cat", image, f"/etc/ros/rosdep/{name}.yaml")


def _names(text: str) -> set[str]:
    """Return the keys of a table of rosdep, or the packages of a distribution file, with their repositories."""
    data = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)) if text else {}
    if "repositories" not in data:
        return set(data)
    released = {name: each.get("release", {}) for name, each in data["repositories"].items()}
    return {package for name, each in released.items() if each for package in each.get("packages") or (name,)}


def _output(*words: str) -> str:
    return subprocess.run(words, capture_output=True, text=True, timeout=120, check=False).stdout
