"""Packages that conda must not take in their newest versions beside others of an environment."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from roslab.config.model import Kind
from roslab.decide.decision import Choice
from roslab.decide.python.conda_channels import further_channels
from roslab.decide.python.conda_cuda import builds_for_cuda
from roslab.decide.python.conda_python import python_of_conda
from roslab.decide.python.own import OwnPython
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.values.conda import CondaPackage, conda_package
from roslab.values.dataclass import replace
from roslab.values.version import Version, version_of

if TYPE_CHECKING:
    from roslab.knowledge.conda_limits import CondaLimit

_WITH_MOST = frozenset({"conda-forge", "defaults", "main", "anaconda"})
"""Channels with packages of every kind; others have a few of their own."""


def limits_of(evidence: Evidence, conda: str | None, kind: Kind, own: OwnPython) -> Choice[tuple[str, ...]]:
    """Return limits for what others of the environment bring: ``mkl<2024.1`` beside an old torch; builds for CUDA.

    And the Python, where the file names none. What the environment names with a version is left to its author.
    """
    environment = next((each for each in evidence.conda if each.file == conda), None)
    if environment is None:
        return Choice(answer=())
    environment = replace(environment, channels=(*environment.channels, *further_channels(evidence, conda)))
    found: dict[str, str] = {}
    if python := python_of_conda(environment, own, evidence.pip_day):
        environment = replace(environment, packages=(python, *environment.packages))
        found[python.written] = "the file names no Python, and conda would take its newest"
    found |= _found(environment)
    if kind == "cuda" and not environment.specs:
        torch = next((package for package in environment.packages if package.name == "pytorch"), None)
        found |= builds_for_cuda(environment, _channel(torch, environment, "pytorch")) if torch else {}
    return Choice(
        answer=tuple(found),
        reasons=tuple(
            because("dependencies", limit, why, environment, weight=Weight.CONDA_FILE) for limit, why in found.items()
        ),
    )


def _found(environment: CondaEnvironment) -> Iterator[tuple[str, str]]:
    from roslab.knowledge.conda_limits import conda_limits  # noqa: PLC0415 - few trees have an environment of conda

    stated = {package.name for package in environment.packages if package.version}
    for row in conda_limits():
        limited = conda_package(row.limit)
        for package in environment.packages:
            if (
                package.name == row.name
                and limited
                and limited.name not in stated
                and _falls(package, row, environment)
            ):
                yield row.limit, f"{package.written}: {row.why}"


def _falls(package: CondaPackage, row: CondaLimit, environment: CondaEnvironment) -> bool:
    """Tell whether a package of an environment is one of a row's; of a channel's, its version may be open."""
    number = version_of(package.version)
    if not row.channel:
        return package.release is not None and number is not None and number < Version(row.before)
    before = not package.version or package.sign.startswith("<") or (number and number < Version(row.before))
    return bool(before) and _channel(package, environment, row.channel) == row.channel


def _channel(package: CondaPackage, environment: CondaEnvironment, meant: str) -> str:
    """Return the channel that a package comes from: its own, else the first one that is meant or has most packages."""
    own, named, _ = package.written.partition("::")
    channels = (each.rstrip("/").rpartition("/")[2] for each in ([own] if named else environment.channels))
    return next((each for each in channels if each == meant or each in _WITH_MOST), "")
