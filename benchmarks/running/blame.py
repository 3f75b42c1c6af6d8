"""Whose a failure is, by a rule on its log: ours or the code's, the stand-in's, or what a program was not given."""

from __future__ import annotations

import io
import re
from collections.abc import Iterable, Mapping

from benchmarks.running.rows import Whose
from benchmarks.running.standins import Base, facts
from roslab.explain.answer import Explanation, explain
from roslab.knowledge.carried import base_holds
from roslab.knowledge.code_limits import bounds_of, version_of
from roslab.knowledge.distros import cmake_of_ubuntu, distro, python_of_ubuntu
from roslab.knowledge.frameworks import framework
from roslab.knowledge.released import released
from roslab.values.name import canonicalize_name
from roslab.values.specifier import specifiers
from roslab.values.version import minor_of
from roslab.values.version import version_of as parsed

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
"""What pip says where one package alone conflicts: it finds none, a limit of another kind, or what it depends on."""
CAUSED = re.compile(r"The conflict is caused by:\s*\n((?:[^\n]*\b(?:The user requested |depends on )[^\n]*\n?)+)")
"""The requests that pip names below, a line each."""
REQUESTED = re.compile(r"The user requested (?:\(constraint\) )?([\w.-]*\w)([^\n]*)")
NO_PACKAGE = re.compile(r"Unable to locate package [^\n]+|Package '[^'\n]+' has no installation candidate")
"""What apt says of each package that it does not know."""
CONSIDERED = re.compile(r"Config\.cmake, version: (\d[\d.]*)|Found unsuitable version \"(\d[\d.]*)")
"""The release that CMake finds and does not take."""
COLOUR = re.compile(r"\x1b\[[0-9;]*m")


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
        if _asked(said) & (base.lacking | _lacks(base)) or _named(found.names, log, base):
            return "stand-in"
        told = f"{said}\n{found.log}"
        of_python = (found.id in known["python"]["ids"] and _python_is_another(base)) or _no_wheel(told, base)
        names = dict(found.names)
        if of_python or (found.id in known["release"]["ids"] and _asks_for_the_plans(names, told, base)):
            return "stand-in"
        had_wheel = found.id in known["wheels"]["ids"] and _had_wheel(log, names.get("package", ""), base)
        if had_wheel or _changed(told, log, base):
            return "stand-in"
    return "ours or the code's" if found.id or found.error else "unclear"


def _lacks(base: Base) -> frozenset[str]:
    """Return what the world has of the ROS packages that the stand-in has for its table alone."""
    return released(_ros(base)) & frozenset(facts()["lacks"].get(base.stand_in, ()))


def _ros(base: Base) -> str:
    """Return the distribution of a base image of ROS, ``""`` for other images."""
    return base.name.removeprefix("ros:").partition("-")[0] if base.name.startswith("ros:") else ""


def _named(names: Iterable[tuple[str, str]], log: str, base: Base) -> bool:
    """Tell whether a failure names what the stand-in alone lacks.

    Where it names several of a kind, the real base has to have each of the others: one that it lacks, too, stops the
    build there.
    """
    of = distro(_ros(base))
    lacking, left_out = base.lacking | _lacks(base), _left_out(log, base)
    held = lacking | (base_holds(of.ros) if of else frozenset())
    for _, value in names:
        several = value.split(", ")
        lacks = [name in lacking or _bare(name) in left_out for name in several]
        if any(lacks) and all(lacked or name in held for name, lacked in zip(several, lacks, strict=True)):
            return True
    return False


def _changed(told: str, log: str, base: Base) -> bool:
    """Tell whether a library's change that lies between the plan's base and the stand-in explains what was told.

    Of packages that apt does not know, it has to explain each.
    """
    rows = [row for row in facts()["change"] if _between(row, base) and re.search(row.get("also", ""), log)]
    if any(re.search(row["pattern"], NO_PACKAGE.sub("", told)) for row in rows):
        return True
    unknown = NO_PACKAGE.findall(told)
    return bool(unknown) and all(any(re.search(row["pattern"], each) for row in rows) for each in unknown)


def _python_is_another(base: Base) -> bool:
    return base.python is not None and not facts()["versions"][base.stand_in]["python"].startswith(base.python)


def _no_wheel(told: str, base: Base) -> bool:
    """Tell whether pip has no release of a framework for the stand-in's Python, and one for the plan's.

    A constraint that names the same release makes that a conflict to pip. One that refuses it, or what the framework
    depends on, is a conflict on the real base, too.
    """
    asked, caused = ALONE.search(told), CAUSED.search(told)
    row = framework(asked[1], asked[2]) if asked and caused and _agree(caused[1], asked[1], asked[2]) else None
    there = minor_of(facts()["versions"][base.stand_in]["python"])
    return bool(row and base.python and there and row.runs_with(base.python) and not row.runs_with(there))


def _agree(caused: str, package: str, release: str) -> bool:
    """Tell whether all that pip says to cause a conflict are requests of one package that take one release."""
    name = canonicalize_name(package)
    limits = [
        specifiers(asked) if canonicalize_name(each) == name else None for each, asked in REQUESTED.findall(caused)
    ]
    return "depends on" not in caused and all(limit is not None and limit.contains(release) for limit in limits)


def _asks_for_the_plans(names: Mapping[str, str], told: str, base: Base) -> bool:
    """Tell whether CMake asks for a release of a library that the plan's base has, and the stand-in has not.

    What CMake finds has to be the stand-in's own, not a release that the build itself brought.
    """
    library, asked = names.get("name", ""), names.get("version", "")
    there = facts()["versions"].get(base.stand_in, {}).get(library)
    real, now, wanted = (parsed(text) if text else None for text in (_of_plan(library, base), there, asked))
    found = {release.group(1) or release.group(2) for release in CONSIDERED.finditer(told)}
    if not (real and now and wanted) or not any(f"{release}.".startswith(f"{there}.") for release in found):
        return False
    if "exact version" in told and real.release[: len(wanted.release)] != wanted.release:
        return False
    least, below = (parsed(text) if text else None for text in bounds_of(library, asked))
    fits = [bool(least and least <= each and not (below and each >= below)) for each in (real, now)]
    return fits == [True, False]


def _had_wheel(log: str, packages: str, base: Base) -> bool:
    """Tell whether each release that pip could not compile has a wheel for the plan's Python, not the stand-in's.

    ``packages`` are those of the failure; the release is that of the archive of sources which the log names.
    """
    return all(_wheel_gone(log, package, base) for package in packages.split(", "))


def _wheel_gone(log: str, package: str, base: Base) -> bool:
    here = ".".join(facts()["versions"][base.stand_in]["python"].split(".")[:2])
    for row in facts()["wheel"]:
        first = {python: parsed(release) for python, release in row["first"].items()}
        begun, ended = first.get(base.python or ""), first.get(here)
        if row["package"] != package or not begun or not ended:
            continue
        found = re.findall(rf"\b{re.escape(package)}-(\d+(?:\.\d+)+)\.(?:tar\.gz|zip)\b", log)
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
