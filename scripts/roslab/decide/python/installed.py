"""Everything that pip and conda install into the image, whatever asked for it."""

from __future__ import annotations

from roslab.decide.python.image_python import Python
from roslab.decide.python.manifests import files_of, with_includes
from roslab.decide.python.mistaken import mistaken
from roslab.decide.python.native_parts import brought
from roslab.decide.python.pins import of_conda
from roslab.decide.python.refused import refused
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.values.interpreter import Interpreter
from roslab.values.requirement import Requirement


def installed(evidence: Evidence, python: Python) -> tuple[Requirement, ...]:
    """Return each requirement once: the image's own, those of its files, projects and conda environment.

    Requirements that pip cannot find or that do not apply to the image's Python and platforms are left out. conda's
    packages have the names that pip's index uses. What these bring follows, where a table says so.
    """
    by_path = {file.file: file for file in evidence.requirements}
    chosen = [by_path[path] for path in python.requirements if path in by_path]
    asked = [each for file in with_includes(evidence, chosen) for each in file.requirements]
    for project in evidence.python:
        if (project.folder or ".") in python.projects:
            asked += [each for each in project.requirements if each.role not in {"extra", "test"}]
    wrong = mistaken(asked)
    asked = [each for each in asked if each not in wrong]
    for environment in evidence.conda:
        if environment.file == python.conda_file:
            asked += (each for each in _of_conda(evidence, environment) if each.name not in python.conda_local)
    beside = [each for each in python.python2 if Interpreter(pythons=("2.7",)).may(each)]
    held = [each for each in (*asked, *python.pip_guessed) if python.interpreter.may(each)]
    first = [each for each in python.pip if python.interpreter.may(each)]
    found: dict[str, Requirement] = {}
    for each in (*first, *beside, *held):
        if not refused(each):
            found.setdefault(each.told, each)
    return (*found.values(), *brought(found.values(), python.day))


def _of_conda(evidence: Evidence, environment: CondaEnvironment) -> list[Requirement]:
    """Return what an environment installs: its ``pip:`` part, conda's own packages, and the files that it names."""
    return [
        *(each for each in environment.requirements if each.role not in {"file", "option"}),
        *of_conda(environment),
        *(each for file in with_includes(evidence, files_of(evidence, environment)) for each in file.requirements),
    ]
