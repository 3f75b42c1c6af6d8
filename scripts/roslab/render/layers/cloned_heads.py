"""What CMake and scripts clone without a commit is of a day: git under another name comes before git itself.

CMake writes down where it found git, and whoever compiles again in the image needs it there: it stays in a folder.
"""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell

FOLDER = "/usr/local/lib/git-as-of"
STAYS = f"COPY --from=scripts /git-as-of {FOLDER}/git\n"
"""Puts it there, behind the script itself."""


def of_day(plan: Plan) -> shell.Around:
    """Return what a step needs so that what it clones without a commit is of the plan's day, nothing for today's."""
    day = plan.workspace.clones_day
    if not day:
        return shell.NOTHING
    return shell.Around(
        before=f"{why(day)}\n{shell.copy_script('git-as-of')}{STAYS}",
        first=(f'eval "$(git-as-of {quote.shell(day)})"',),
    )


def why(day: str) -> str:
    """Return the comment that says of which day it is what is cloned."""
    return f"# What this clones without a commit is of {quote.checked(day)}"
