"""The repository's folder as one of git, whose history is in no image."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers.workspace import source_folder

_COMMIT = (
    " \\\n && GIT_AUTHOR_DATE='315532800 +0000' GIT_COMMITTER_DATE='315532800 +0000'"
    " \\\n    git -C {folder} -c user.name=roslab -c user.email=roslab@localhost"
    " \\\n      commit --quiet --allow-empty --message 'The source is here without its history'"
)
"""The same in each build; nothing is in it."""


def made(plan: Plan) -> str:
    """Make the folder of the source one of git, with an empty commit, where the code asks git for either."""
    if not plan.workspace.git_folder:
        return ""
    folder = quote.shell_with_user(source_folder(plan))
    return (
        "# The code asks git for the repository's folder, or its commit: an empty one, for the history is in no image\n"
        "USER ${NB_USER}\n"
        f"RUN git init --quiet --template= {folder}{_COMMIT.format(folder=folder)}"
    )
