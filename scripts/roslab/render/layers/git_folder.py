"""The repository's folder as one of git, whose history is in no image."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers.workspace import HOME, source_folder

_AUTHOR = "git -c user.name=roslab -c user.email=roslab@localhost"
_DAY = "1980-01-01T00:00:00Z"
"""Of the commit, whose name is the same in every image so."""


def made(plan: Plan) -> str:
    """Make the folder of the source one of git where the code asks git for that folder: one commit, without a file.

    Code that asks for the commit stops where there is none. CMake runs programs where it was started, which is the
    build folder: where that lies beside the source, it is told of the same repository.
    """
    if not plan.workspace.git_folder:
        return ""
    folder = quote.shell_with_user(source_folder(plan))
    return (
        f"# The code asks git about the repository's folder; the history is in no image\nUSER ${{NB_USER}}\n"
        f"RUN git init --quiet --template= {folder} \\\n"
        f" && GIT_AUTHOR_DATE={_DAY} GIT_COMMITTER_DATE={_DAY} {_AUTHOR} -C {folder} \\\n"
        f"      commit --quiet --allow-empty --message 'The history is in no image'{_beside(plan)}"
    )


def _beside(plan: Plan) -> str:
    """Return the command that has git find the repository from the build folder, ``""`` where that lies inside.

    https://git-scm.com/docs/gitrepository-layout: a file ``.git`` names the repository's folder.
    """
    program = plan.workspace.program
    if program is None or f"{HOME}/{program.build}".startswith(f"{source_folder(plan)}/"):
        return ""
    build = quote.shell_with_user(f"{HOME}/{program.build}")
    named = quote.shell_with_user(f"gitdir: {source_folder(plan)}/.git")
    return f" \\\n && mkdir --parents {build} && echo {named} >{build}/.git"
