"""The command that tests the image, if roslab.yaml, an input or an option names one."""

from __future__ import annotations

import re
from collections.abc import Collection

from roslab.config.model import BuildTool, Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.reasons import configured
from roslab.decide.system.own_options import own_options
from roslab.decide.system.unreached import unreached
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern
from roslab.values.words import line_of

_OFF = pattern(r"=(?:OFF|FALSE|NO|0)$", re.IGNORECASE)


def decide_test(config: Config) -> Choice[tuple[str, ...] | str | None]:
    """Return the command that tests the image, ``None`` for the default proofs of its kind."""
    if not config.test:
        return Choice(answer=None)
    text = line_of(config.test)
    return Choice(answer=config.test, reasons=(configured(config, "test", text, "test"),))


def compiled(evidence: Evidence) -> frozenset[str]:
    """Return the names of the programs that CMake makes, without those of tests and of code that was copied in."""
    apart = (places.test, places.vendored)
    projects = (project for project in evidence.cmake if not any(kind(project.file) for kind in apart))
    return frozenset(name for project in projects for name, _ in project.executables)


def runs_ctest(
    evidence: Evidence, config: Config, folder_name: str, build_tool: BuildTool, left_out: Collection[str]
) -> bool:
    """Tell whether there are tests for ctest; ``left_out``: the options by which the build leaves tests out.

    None that wait for an option which is off by itself and which the build does not set, nor those of a project that no
    build comes to.
    """
    if build_tool != "cmake" or left_out:
        return False
    given = (*own_options(evidence, config, folder_name, build_tool), *config.cmake_options.split(), *config.build_args)
    last = {word.partition("=")[0].partition(":")[0].removeprefix("-D"): not _OFF.search(word) for word in given}
    on = {name for name, set_on in last.items() if set_on}
    other = unreached(evidence)
    tested = (p for p in evidence.cmake if p.tests and not (places.vendored(p.file) or p.file in other))
    return any(on.issuperset(project.untested) for project in tested)


def rostests(evidence: Evidence, kind: Kind, build_tool: BuildTool) -> tuple[str, ...]:
    """Return the launch files whose tests run in an image that holds no test programs: paths relative to the root.

    A workspace is built without its tests, so that each program that they start must be a file of the tree, another
    package's, or one that is built anyway.
    """
    if kind != "ros1" or build_tool == "none":
        return ()
    own = {manifest.name for manifest in evidence.manifests}
    built = compiled(evidence)
    return tuple(
        launch.file
        for launch in evidence.launch
        if launch.tests and not any(package in own and program not in built for package, program in launch.compiled)
    )
