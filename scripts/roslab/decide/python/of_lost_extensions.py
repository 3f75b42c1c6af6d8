"""Projects of Python whose extension cannot be compiled here: what they require is installed all the same."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.decide.decision import Choice, Warning_
from roslab.decide.python.image_python import Python
from roslab.decide.python.may_bring import absent
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject
from roslab.values.dataclass import replace

_MADE = (
    "no file of the tree is {header}, which {tool} makes with its code or brings, and the extension of {name} includes "
    "it: pip will stop at that, and only what it requires is installed; add the code that {tool} made to the repository"
)


def with_lost_extensions(choice: Choice[Python], folders: Collection[str], evidence: Evidence) -> Choice[Python]:
    """Add what the projects of these folders require, which pip installs where it stops at them.

    ``folders``: of those whose CMake requires what nothing brings; those whose sources include what a licensed program
    makes are told with them. Only what the image installs is such a project.
    """
    installed = [each for each in evidence.python if (each.folder or ".") in choice.answer.projects]
    made = dict(_without_made(evidence, installed))
    lost = []
    for project in installed:
        if project.folder in folders or project.folder in made:
            asked = (each for each in project.requirements if each.role == "" and each.name)
            lost.append((project.folder or ".", tuple(each for each in asked if choice.answer.interpreter.may(each))))
    if not lost:
        return choice
    answer = replace(choice.answer, lost_extensions=tuple(lost))
    return replace(choice, answer=answer, warnings=(*choice.warnings, *made.values()))


def _without_made(evidence: Evidence, projects: Collection[PythonProject]) -> Iterator[tuple[str, Warning_]]:
    """Yield each folder once, with what is told of it; nothing where a submodule is not there, which may have it."""
    names = {} if absent(evidence) else {each.folder: each.name for each in projects}
    told: set[str] = set()
    for said in evidence.mentions:
        if said.topic == "made_header" and said.inside in names and said.inside not in told:
            told.add(said.inside)
            name = names[said.inside] or "the project"
            yield said.inside, warn(_MADE.format(header=said.value, tool=said.text, name=name), said)
