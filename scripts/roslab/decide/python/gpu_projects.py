"""Projects of the tree that cannot be installed while an image is built, as their setup.py asks for a GPU."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence import places
from roslab.evidence.facts import Evidence, PythonProject


def only_on_gpu(project: PythonProject) -> bool:
    """Tell whether a project is left out: one in a folder, for that at the root brings what the rest needs, too."""
    return bool(project.folder) and "gpu" in project.extensions


def left_to_gpus(evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for each such project, with what installs it."""
    for project in evidence.python:
        if not project.installable or "gpu" not in project.extensions or places.aside(project.file):
            continue
        where = project.folder or "."
        what = f"{where} is not installed" if only_on_gpu(project) else "the project at the root may stop the build"
        then = f"`pip install --no-build-isolation {where}` in a container with --gpus all"
        yield warn(f"{what}: its setup.py ends where torch sees no GPU, as in every build of an image; {then}", project)
