"""The plan as text: the files that ``create`` writes, and the report of a build."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render.build_script import build_script
from roslab.render.dockerfile import dockerfile
from roslab.render.ignore import ignore
from roslab.render.notebook import notebook
from roslab.render.output import MARKER, OutputFile
from roslab.render.run_script import run_script

__all__ = ["MARKER", "OutputFile", "render_all"]


def render_all(
    plan: Plan, *, readme: str | None, output_is_root: bool, context: str, readme_name: str = "README.md"
) -> tuple[OutputFile, ...]:
    """Return every file of a plan, in the order in which they are shown.

    ``context`` is the repository, relative to the folder that the files are written to; ``readme`` is the text of the
    file ``readme_name``. An author's own Dockerfile is built where it stands: for it there is no Dockerfile.
    """
    root = "." if output_is_root else context
    authored = (
        ()
        if plan.author_dockerfile
        else (
            OutputFile(path="Dockerfile", text=dockerfile(plan)),
            OutputFile(path="Dockerfile.dockerignore", text=ignore(plan)),
        )
    )
    return (
        *authored,
        OutputFile(path="docker_build.sh", text=build_script(plan, context=root), executable=True),
        OutputFile(path="docker_run.sh", text=run_script(plan, context=root), executable=True),
        OutputFile(path="README.ipynb", text=notebook(plan, readme=readme, readme_name=readme_name)),
    )
