"""The command that tests the image, if roslab.yaml, an input or an option names one."""

from __future__ import annotations

from collections.abc import Collection

from roslab.config.model import BuildTool, Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.reasons import configured
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.words import line_of


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


def runs_ctest(evidence: Evidence, build_tool: BuildTool, left_out: Collection[str]) -> bool:
    """Tell whether there are tests for ctest; ``left_out``: the options by which the build leaves tests out."""
    has_tests = any(project.tests and not places.vendored(project.file) for project in evidence.cmake)
    return build_tool == "cmake" and has_tests and not left_out


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
