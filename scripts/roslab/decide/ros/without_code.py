"""Packages that CMake cannot configure.

They compile files of code which the tree does not have, or add a folder that it does not have or that is one of their
author's computer, or link a library in such a one.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from roslab.config.model import BuildTool
from roslab.decide.decision import Warning_
from roslab.decide.programs import configured_by
from roslab.decide.reasons import warn
from roslab.decide.ros.skipped import Skipped
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import SKIP, needing
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence
from roslab.evidence.native.authors_parts import LIBRARY
from roslab.values.origin import Place


def without_code(
    evidence: Evidence,
    packages: Packages,
    build_tool: BuildTool,
    *,
    started: Collection[str],
    left: Mapping[str, Skipped],
) -> tuple[dict[str, Skipped], tuple[Warning_, ...]]:
    """Return the packages that are left out, those of ``left`` and these with what needs them, and a warning for each.

    As far as something else is built and nothing of it is started; else the build stops there, which is told too.
    """
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    out, warnings = dict(left), []
    for project in evidence.cmake:
        stops = stopping(project)
        package = configured_by(project, folders) if stops else None
        if package is None or stops is None or package in out:
            continue
        lacks, line, hint = stops
        place = Place(file=project.file, line=line)
        with_it = needing(package, packages)
        others = {m.name for m in packages.built if not m.metapackage} - out.keys() - {*with_it}
        skipped = build_tool in SKIP and others and not {*with_it} & {*started}
        more = f", and with it {', '.join(with_it[1:])}" if with_it[1:] else ""
        then = f"{package} is left out of the build{more}" if skipped else f"{build_tool} will stop at {package}"
        warnings.append(warn(f"{lacks}: {then}; {hint}", place))
        if skipped:
            out |= {name: Skipped(place, lacks) for name in with_it if name not in out}
    return out, tuple(warnings)


def stopping(project: CMakeProject) -> tuple[str, int, str] | None:
    """Return at what CMake stops, with its line, and what to do about it, if it does."""
    if project.without:
        path, line = project.without[0]
        return f"CMake compiles {path}, which the tree does not have", line, "add the file, or correct the path"
    if project.parts:
        path, line = project.parts[0]
        if LIBRARY.fullmatch(path):
            return f"CMake links {path}, a file of its author's computer", line, "add the library to the tree"
        return f"CMake adds {path}, a folder of its author's computer", line, "add the folder to the tree"
    if project.absent:
        path, line = project.absent[0]
        return f"CMake adds {path}, which the tree does not have", line, "add the folder, or correct the path"
    return None


def unconfigurable(evidence: Evidence, packages: Packages) -> frozenset[str]:
    """Return the names of the packages that CMake cannot configure, and of those that cannot be built without them."""
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    stopped = {configured_by(project, folders) for project in evidence.cmake if stopping(project)}
    return frozenset(each for name in stopped if name for each in needing(name, packages))
