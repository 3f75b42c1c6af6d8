"""Why each part of the Python packages is installed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Reason
from roslab.decide.python.imported_submodules import imported
from roslab.decide.python.packages import Chosen
from roslab.decide.python.unmade_environments import ORIGIN
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.values.origin import Place
from roslab.values.requirement import Requirement

_WHY = {
    "import": "imported, declared nowhere",
    "build": "the build asks for a newer one than the base has",
    ORIGIN: "the environment that is not made has it, and the project does not name it",
}
_BY_NAME = "imported by what a command starts, declared nowhere and in no table: the package of its name is tried"
_OF_OWNER = "the project needs it, and a page links to its owner's repository of that name"
_ALONE = "conda alone has it: it comes from there, with the Python"


def reasons_of(chosen: Chosen, alone: Iterable[Requirement]) -> Iterator[Reason]:
    """Yield a reason for each list, project, environment and package; ``alone``: what conda alone has."""
    for file in chosen.files:
        yield because("dependencies", file.file, "requirements of the project", file, weight=Weight.MANIFEST)
    sought = {*imported(chosen.projects)}
    for project in chosen.projects:
        why = "installable project" if project.folder not in sought else "imported, and the submodule is called like it"
        yield because("dependencies", project.folder or ".", why, project, weight=Weight.MANIFEST)
    for asked in chosen.declared:
        stops = "" if asked.file.endswith("Pipfile") else "; what builds the project stops at it"
        why = f"{asked.file} declares it{stops}"
        yield because("dependencies", asked.text, why, asked, weight=Weight.MANIFEST)
    declaring = {asked.file for project in chosen.projects for asked in project.requirements}
    for asked in chosen.guessed:
        said = "a page lists it" if asked.role == "listed" else "named in an install line"
        why = "imported, only an extra declares it" if asked.group else _WHY.get(asked.origin, said)
        why = _BY_NAME if asked.key in chosen.by_name and asked.origin == "import" else why
        why = _OF_OWNER if asked.url and asked.file in declaring else why
        yield because("dependencies", asked.text, why, asked, weight=Weight.GUESS)
    if chosen.conda:
        place = Place(file=chosen.conda, line=1)
        yield because("dependencies", chosen.conda, "the project's conda environment", place, weight=Weight.CONDA_FILE)
    yield from (because("dependencies", each.text, _ALONE, each, weight=Weight.CONDA_FILE) for each in alone)
