"""Which pip a conda environment gets, where the one that its file asks for cannot install what the file lists."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Reason
from roslab.decide.python.image_python import Python
from roslab.decide.python.pins import of_conda
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import build_needs
from roslab.knowledge.tools import ALWAYS_ISOLATED
from roslab.values.origin import Place
from roslab.values.version import Version

NEW_WHEELS = Version("20.3")
"""The first pip that takes every kind of wheel for Linux (PEP 600). https://github.com/pypa/manylinux#readme"""


def old_pip(evidence: Evidence, conda: str | None) -> str:
    """Return the pip that an environment pins, if it is too old for the wheels of later days; else ``""``."""
    packages = (package for each in evidence.conda if each.file == conda for package in each.packages)
    pinned = next((package.release for package in packages if package.name == "pip" and package.release), "")
    return pinned if pinned and Version(pinned) < NEW_WHEELS else ""


def pip_below(evidence: Evidence, conda: str | None) -> str:
    """Return the first pip that is too new for an environment, which names pip in any version; else ``""``.

    It is where pip compiles what may need the torch that conda has installed by then.
    """
    environment = next((each for each in evidence.conda if each.file == conda), None)
    return ALWAYS_ISOLATED if environment and _any_pip(environment) and _on_torch(environment) else ""


def _any_pip(environment: CondaEnvironment) -> bool:
    return any(package.written == "pip" for package in environment.packages)


def _on_torch(environment: CondaEnvironment) -> bool:
    """Tell whether conda installs torch, and pip then builds what may be an extension of it."""
    built = any(each.vcs or "torch" in build_needs().get(each.key, ()) for each in environment.requirements)
    return built and any(asked.key == "torch" for asked in of_conda(environment))


def of_conda_pip(answer: Python) -> Iterator[Reason]:
    """Yield why an environment gets another pip than its file asks for."""
    if not answer.conda_file:
        return
    place = Place(file=answer.conda_file)
    if answer.conda_old_pip:
        why = f"{answer.conda_file} pins {answer.conda_old_pip}, which knows no wheels of later days: it is the newest"
        yield because("dependencies", "pip", why, place, weight=Weight.CONDA_FILE)
    if answer.conda_pip_below:
        why = f"{answer.conda_file} names any, and newer ones hide conda's torch from what they build"
        yield because("dependencies", f"pip<{answer.conda_pip_below}", why, place, weight=Weight.CONDA_FILE)
