"""The plan as text: the files that ``create`` writes, and the report of a build."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from roslab.plan.plan import Plan
from roslab.render.build_script import build_script
from roslab.render.dockerfile import dockerfile
from roslab.render.ignore import ignore
from roslab.render.notebook import notebook
from roslab.render.output import MARKER, OutputFile
from roslab.render.run_script import run_script

__all__ = ["FILES", "MARKER", "OutputFile", "render_all"]


@dataclass(frozen=True, kw_only=True, slots=True)
class Beside:
    """What lies beside the files that are written."""

    context: str
    """The repository, relative to the folder that the files are written to."""
    readme: str | None
    readme_name: str


@dataclass(frozen=True, kw_only=True, slots=True)
class File:
    """One file of every plan, and how its text is made."""

    path: str
    text: Callable[[Plan, Beside], str]
    executable: bool = False
    generated_only: bool = False
    """It belongs to a generated Dockerfile: where the author's own is built, it is not written."""
    read_in_image: bool = False
    """A program in the image opens it. The build does not see the others: a change of one must not repeat it."""


FILES: tuple[File, ...] = (
    File(path="Dockerfile", text=lambda plan, _: dockerfile(plan), generated_only=True),
    File(path="Dockerfile.dockerignore", text=lambda plan, _: ignore(plan, _unread()), generated_only=True),
    File(path="docker_build.sh", text=lambda plan, at: build_script(plan, context=at.context), executable=True),
    File(path="docker_run.sh", text=lambda plan, at: run_script(plan, context=at.context), executable=True),
    File(
        path="README.ipynb",  # JupyterLab opens it
        text=lambda plan, at: notebook(plan, readme=at.readme, readme_name=at.readme_name),
        read_in_image=True,
    ),
)
"""Every file, in the order in which they are shown; a new one is a line here."""


def render_all(
    plan: Plan, *, readme: str | None, output_is_root: bool, context: str, readme_name: str = "README.md"
) -> tuple[OutputFile, ...]:
    """Return every file of a plan, in the order in which they are shown.

    ``context`` is the repository, relative to the folder that the files are written to; ``readme`` is the text of the
    file ``readme_name``. An author's own Dockerfile is built where it stands: for it there is no Dockerfile.
    """
    beside = Beside(context="." if output_is_root else context, readme=readme, readme_name=readme_name)
    written = (file for file in FILES if not (file.generated_only and plan.author_dockerfile))
    return tuple(
        OutputFile(path=file.path, text=file.text(plan, beside), executable=file.executable) for file in written
    )


def _unread() -> tuple[str, ...]:
    return tuple(file.path for file in FILES if not file.read_in_image)
