"""The repository's folder as one of git, whose history is in no image."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers.workspace import source_folder


def made(plan: Plan) -> str:
    """Make the folder of the source one of git, which has nothing in it, where the code asks git for that folder."""
    if not plan.workspace.git_folder:
        return ""
    folder = quote.shell_with_user(source_folder(plan))
    return (
        f"# The code asks git for the repository's folder\nUSER ${{NB_USER}}\nRUN git init --quiet --template= {folder}"
    )
