"""The repository's folder as one of git, whose history is in no image."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers.workspace import source_folder

_AUTHOR = "git -c user.name=roslab -c user.email=roslab@localhost"
_DAY = "1980-01-01T00:00:00Z"
"""Of the commit, whose name is the same in every image so."""


def made(plan: Plan) -> str:
    """Make the folder of the source one of git where the code asks git for that folder: one commit, without a file.

    Code that asks for the commit stops where there is none.
    """
    if not plan.workspace.git_folder:
        return ""
    folder = quote.shell_with_user(source_folder(plan))
    return (
        f"# The code asks git about the repository's folder; the history is in no image\nUSER ${{NB_USER}}\n"
        f"RUN git init --quiet --template= {folder} \\\n"
        f" && GIT_AUTHOR_DATE={_DAY} GIT_COMMITTER_DATE={_DAY} {_AUTHOR} -C {folder} \\\n"
        "      commit --quiet --allow-empty --message 'The history is in no image'"
    )
