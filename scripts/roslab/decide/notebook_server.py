"""The server that opens a notebook: the one that the tree declares, JupyterLab or the notebook's own."""

from __future__ import annotations

from roslab.decide.candidate import Candidate
from roslab.decide.scripts import LAB, NOTEBOOK
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

_LAB = "jupyterlab"
_OWN = frozenset({"jupyter", "notebook"})
"""Packages with ``jupyter notebook``, which JupyterLab alone may lack."""


def server(evidence: Evidence) -> tuple[str, ...]:
    """Return the call of the server: that of JupyterLab where it is declared, and the notebook's own is nowhere."""
    listed = [*evidence.prose_pip, *(asked for each in evidence.conda for asked in each.requirements)]
    listed += (asked for each in evidence.requirements for asked in each.requirements)
    listed += (asked for each in evidence.python for asked in each.requirements)
    names = {asked.key for asked in listed if not places.vendored(asked.file)}
    names |= {package.name for each in evidence.conda for package in each.packages}
    return LAB if _LAB in names and names.isdisjoint(_OWN) else NOTEBOOK


def package_of_server(evidence: Evidence) -> str:
    """Return the package that has the server."""
    return _LAB if server(evidence) == LAB else "notebook"


def served(candidate: Candidate, evidence: Evidence) -> Candidate:
    """Return a command with the tree's own server, where it opens a notebook."""
    if candidate.argv[: len(NOTEBOOK)] != NOTEBOOK:
        return candidate
    return replace(candidate, argv=(*server(evidence), *candidate.argv[len(NOTEBOOK) :]))
