"""Which requirement files, projects and packages the image's Python gets."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Config, Kind
from roslab.decide.python.after_conda import after_conda
from roslab.decide.python.bare import needs_of
from roslab.decide.python.companions import companions_of
from roslab.decide.python.conda_environments import conda_file
from roslab.decide.python.contradicting import afterwards, of_one_call
from roslab.decide.python.environment_extras import for_environments
from roslab.decide.python.extras import extras, of_pages
from roslab.decide.python.gpu_projects import by_scripts
from roslab.decide.python.guesses import guesses, known_names, known_requirements, loose_names, to_show
from roslab.decide.python.manifests import projects, requirement_files
from roslab.decide.python.newer_parts import newer_parts
from roslab.decide.python.of_nodes import of_nodes
from roslab.decide.python.pins import DEVELOPMENT, Pin
from roslab.decide.python.unmade_environments import of_unmade
from roslab.evidence.facts import Evidence, Mention, RequirementFile
from roslab.evidence.python_project import PythonProject
from roslab.values.dataclass import dataclass, replace
from roslab.values.requirement import Requirement

_THERE = frozenset({"setuptools", "wheel"})
"""What is installed with pip."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Chosen:
    """The chosen files, projects and packages, each with the place that names it."""

    files: tuple[RequirementFile, ...] = ()
    contradicting: tuple[RequirementFile, ...] = ()
    """Files with a pin that one of those contradicts."""
    projects: tuple[PythonProject, ...] = ()
    declared: tuple[Requirement, ...] = ()
    """What a project at the root needs whose backend refuses to install it: pip installs these alone."""
    guessed: tuple[Requirement, ...] = ()
    options: tuple[str, ...] = ()
    conda: str | None = None
    """Path of the conda environment."""
    by_name: tuple[str, ...] = ()
    """Of the guessed packages, those of which nothing is known but that a module is called so."""
    stopping: tuple[Mention, ...] = ()
    """Modules of no table that the default command imports before it does anything, each with its place."""

    @property
    def built_with(self) -> frozenset[str]:
        """What pip fetches to build the projects, beside what it has."""
        return frozenset({each.key for project in self.projects for each in project.build_requires} - _THERE)


def choose(evidence: Evidence, config: Config, kind: Kind, pins: tuple[Pin, ...], ubuntu: str | None = None) -> Chosen:
    """Return what pip or conda installs; ``ubuntu``: that of ROS, whose packages of Python are there."""
    conda = conda_file(evidence, config, kind)
    files = requirement_files(evidence, config, kind, conda)
    whole = conda is None and config.requirements is None
    kept, left = of_one_call(evidence, files) if whole else (files, ())
    folders = projects(evidence, kind, conda, files, by_scripts(evidence, config, kind))
    ros = kind in {"ros1", "ros2"}
    declared = () if ros or files or conda or folders else tuple(_of_refused(evidence))
    manifests = bool(files or conda or declared or any(project.requirements for project in folders))
    known = known_names(evidence, files, folders, conda) | {each.key for each in declared}
    loose = frozenset() if ros or conda else loose_names(evidence, files, folders)
    more = tuple(each for each in extras(evidence, folders, files) if each.key not in known)
    known |= {each.key for each in more}
    sure = (*known_requirements(evidence, files, folders, conda), *more)
    guessed = guesses(evidence, pins, kind, manifests=manifests, known=known, loose=loose)
    listed = {each.key: each for each in after_conda(evidence, conda, known)}
    guessed = tuple(listed.pop(each.key, each) for each in guessed)
    guessed += tuple(listed.values())
    if not (files or conda):
        guessed += tuple(of_unmade(evidence, kind, folders, known | {each.key for each in guessed}))
    guessed += tuple(newer_parts(evidence, kind, known | {each.key for each in guessed}, ubuntu))
    guessed += tuple(of_nodes(evidence, kind, known | {each.key for each in guessed}))
    return Chosen(
        files=kept,
        contradicting=left,
        projects=folders,
        declared=declared,
        guessed=(
            *more,
            *of_pages(evidence, files, folders),
            *guessed,
            *for_environments(evidence, guessed, known),
            *companions_of(evidence, guessed, sure, known),
            *needs_of(guessed, known | {each.key for each in guessed}),
            *to_show(evidence, known | {each.key for each in guessed}),
            *afterwards(evidence, kept, left),
        ),
        options=tuple(dict.fromkeys(_options(evidence))),
        conda=conda,
    )


def _of_refused(evidence: Evidence) -> Iterator[Requirement]:
    for project in evidence.python:
        if project.refused and not project.folder:
            yield from (asked for asked in project.requirements if asked.role in {"", "source"})


def with_guess(chosen: Chosen, guess: Requirement) -> Chosen:
    """Add a guess, which replaces other guesses for the same package."""
    others = (other for other in chosen.guessed if other.key != guess.key)
    return replace(chosen, guessed=(*others, guess))


def _options(evidence: Evidence) -> Iterator[str]:
    """Yield the pip options in install lines; their indexes are added to the usual one, never replace it."""
    said = [asked for asked in evidence.prose_pip if not DEVELOPMENT.search(asked.file)]
    said += [asked for r in evidence.dockerfiles if r.purpose == "project" for asked in r.requirements]
    for asked in said:
        if asked.role == "option" and asked.written.startswith("--index-url"):
            yield asked.written.replace("--index-url", "--extra-index-url")
        elif asked.role == "option":
            yield asked.written
