"""Projects of the tree that cannot be installed while an image is built, as their setup.py asks for a GPU."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Config, Kind
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.system.run_by_pages import MOST, run_by_pages
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject

_ASKED = "gpu asked"


def _stops(project: PythonProject, kind: Kind) -> bool:
    """Tell whether a build stops: the image can say that there is a GPU, where it has what compiles for one."""
    return "gpu" in project.extensions or (_ASKED in project.extensions and kind != "cuda")


def only_on_gpu(project: PythonProject, kind: Kind) -> bool:
    """Tell whether a project is left out: one in a folder, for that at the root brings what the rest needs, too."""
    return bool(project.folder) and _stops(project, kind)


def asking(evidence: Evidence, kind: Kind) -> tuple[str, ...]:
    """Return the folders of the projects that are told that there is a GPU, ``.`` for the root."""
    found = (p for p in evidence.python if _ASKED in p.extensions and not _stops(p, kind))
    return tuple(dict.fromkeys(project.folder or "." for project in found))


def by_scripts(evidence: Evidence, config: Config, kind: Kind) -> frozenset[str]:
    """Return the folders of those that ask and that a script of the page compiles in the image, beside the program."""
    asking_too = {p.folder for p in evidence.python if p.folder and _ASKED in p.extensions}
    if not asking_too:
        return frozenset()
    return frozenset(script.folder for script, _ in run_by_pages(evidence, config, kind)[:MOST]) & asking_too


def left_to_gpus(evidence: Evidence, kind: Kind) -> Iterator[Warning_]:
    """Yield a warning for each project that is left to a machine with a GPU, with what installs it."""
    for project in evidence.python:
        if not (project.installable and _stops(project, kind)) or places.aside(project.file):
            continue
        where = project.folder or "."
        what = (
            f"{where} is not installed" if only_on_gpu(project, kind) else "the project at the root may stop the build"
        )
        then = f"`pip install --no-build-isolation {where}` in a container with --gpus all"
        yield warn(f"{what}: its setup.py ends where torch sees no GPU, as in every build of an image; {then}", project)
