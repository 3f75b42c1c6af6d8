"""The plan as text: the files that ``create`` writes, and the report of a build."""

from __future__ import annotations

from importlib import import_module
from typing import Literal

from roslab.plan.plan import Plan
from roslab.render.output import MARKER, Beside, OutputFile
from roslab.values.dataclass import dataclass

__all__ = ["FILES", "MARKER", "OutputFile", "render_all"]


@dataclass(frozen=True, kw_only=True, slots=True)
class File:
    """One file of every plan, and the module that makes its text."""

    path: str
    module: str
    """Its ``text(plan, beside)`` returns the file; it is imported only for writing, as planning does not need it."""
    executable: bool = False
    goes_with: Literal["anything", "generated", "bases"] = "anything"
    """``generated``: it is not written if the author's own Dockerfile is built; ``bases``: only if that starts from
    images that are replaced."""
    read_in_image: bool = False
    """A program in the image opens it. Other files are hidden from the build: changing one must not repeat it."""


FILES: tuple[File, ...] = (
    File(path="Dockerfile", module="dockerfile", goes_with="generated"),
    File(path="Dockerfile.dockerignore", module="ignore", goes_with="generated"),
    File(path="Dockerfile.bases", module="bases", goes_with="bases"),
    File(path="docker_build.sh", module="build_script", executable=True),
    File(path="docker_run.sh", module="run_script", executable=True),
    File(path="README.ipynb", module="notebook", read_in_image=True),  # JupyterLab opens it
)
"""Every file, in the order in which they are shown; a new file needs one more line here."""


def render_all(
    plan: Plan, *, readme: str | None, output_is_root: bool, context: str, readme_name: str = "README.md"
) -> tuple[OutputFile, ...]:
    """Return every file of a plan, in the order in which they are shown.

    ``context`` is the repository, relative to the folder that the files are written to; ``readme`` is the text of the
    file ``readme_name``. An author's own Dockerfile is built where it is, so no Dockerfile is written for it.
    """
    beside = Beside(
        context="." if output_is_root else context,
        readme=readme,
        readme_name=readme_name,
        unread=tuple(file.path for file in FILES if not file.read_in_image),
    )
    authored = plan.author_dockerfile
    left_out = "generated" if authored else "bases"
    written = (file for file in FILES if file.goes_with != left_out)
    if authored and not authored.bases:
        written = (file for file in written if file.goes_with != "bases")
    return tuple(
        OutputFile(path=file.path, text=_text(file, plan, beside), executable=file.executable) for file in written
    )


def _text(file: File, plan: Plan, beside: Beside) -> str:
    text: str = import_module(f"{__name__}.{file.module}").text(plan, beside)
    return text
