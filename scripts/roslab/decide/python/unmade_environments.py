"""What a conda environment that is not made has of torch, and the project that is installed in its place does not name.

People make such an environment first, for its builds for GPUs, and have pip install the project into it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set

from roslab.config.model import Kind
from roslab.decide.python.conda_environments import OF_OTHER_SYSTEM
from roslab.decide.python.manifests import VARIANT
from roslab.decide.python.pins import of_conda
from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.frameworks import family_of
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement

_TORCH = "torch"
ORIGIN = "conda"
"""Origin of what is taken from there, which nothing else that is guessed has."""


def of_unmade(
    evidence: Evidence, kind: Kind, projects: Sequence[PythonProject], known: Set[str]
) -> Iterator[Requirement]:
    """Yield torch and what is released with it from the one environment at the root, without what is ``known``.

    Only where the project at the root is installed: with a list of pip's the author says another way.
    """
    at_root = (each for each in evidence.conda if "/" not in each.file and not each.specs)
    found = [each for each in at_root if not OF_OTHER_SYSTEM.search(each.file)]
    plain = [each for each in found if not VARIANT.search(each.file.rpartition(".")[0])] or found
    if kind not in {"python", "cuda"} or len(plain) != 1 or all(project.folder for project in projects):
        return
    for asked in of_conda(plain[0]):
        if asked.key in family_of(_TORCH) - known:
            yield replace(asked, role="")
