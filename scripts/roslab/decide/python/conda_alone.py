"""Packages that conda alone has and that a page installs by it: they come from there, with the Python."""

from __future__ import annotations

from roslab.decide.python.own import OwnPython
from roslab.decide.python.pins import DEVELOPMENT
from roslab.decide.python.refused import refused
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class CondaAlone:
    """What conda installs in place of an environment file."""

    asked: tuple[Requirement, ...] = ()
    specs: tuple[str, ...] = ()
    """With the Python, as conda writes them: ``python=3.8``."""
    channels: tuple[str, ...] = ()


def conda_alone(evidence: Evidence, own: OwnPython) -> CondaAlone:
    """Return what a page, or a script that it runs, installs by conda and pip's index lacks.

    Nothing where there is an environment file, or where no page creates the environment with this very Python: conda
    has such a package for few versions, and the author's is one of them.
    """
    created = any(
        said.topic == "python" and said.value == own.version and "conda" in said.text for said in evidence.mentions
    )
    if own.system or own.chosen.conda or not created:
        return CondaAlone()
    found: dict[str, Requirement] = {}
    channels: dict[str, None] = {}
    for asked in evidence.prose_pip:
        row = refused(asked) if asked.role == "conda" else None
        if row and row.conda and asked.file.count("/") <= 1 and not DEVELOPMENT.search(asked.file):
            found.setdefault(asked.key, asked)
            channels |= dict.fromkeys(row.conda)
    if not found:
        return CondaAlone()
    specs = (f"{asked.name}={asked.release}" if asked.release else asked.name for asked in found.values())
    return CondaAlone(asked=tuple(found.values()), specs=(f"python={own.version}", *specs), channels=tuple(channels))
