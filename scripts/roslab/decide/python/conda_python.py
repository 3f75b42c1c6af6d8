"""The Python of a conda environment that names none: conda would take its newest, without wheels of old packages."""

from __future__ import annotations

from roslab.decide.python.own import OwnPython
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.values.conda import CondaPackage, conda_package
from roslab.values.pattern import pattern

_BUILT_FOR = pattern(r"py(\d)(\d+)(?!\d)")
"""The Python in a build string: ``py38_0``."""


def python_of_conda(environment: CondaEnvironment, own: OwnPython, day: str | None) -> CondaPackage | None:
    """Return the Python to take in an environment whose file names no version of it, ``None`` for conda's choice.

    That is the one which the rest asks for; else that of the day of pip's packages, if no package of conda has a
    version that could need another.
    """
    named = any(each.name == "python" and each.version for each in environment.packages)
    if named or environment.python or environment.specs or not own.version:
        return None
    built = {f"{found[1]}.{found[2]}" for each in environment.packages if (found := _BUILT_FOR.search(each.build))}
    if not built <= {own.version}:
        return None
    free = not any(each.version for each in environment.packages)
    return conda_package(f"python={own.version}") if own.wanted or (day and free) else None
