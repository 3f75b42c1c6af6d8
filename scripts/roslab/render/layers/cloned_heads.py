"""What CMake clones without a commit is of a day: git under another name comes before git itself."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell

_FOLDER = "/dev/shm/as-of"  # noqa: S108 - a folder of the step alone, in memory


def of_day(plan: Plan) -> shell.Around:
    """Return what a step needs so that what it clones without a commit is of the plan's day, nothing for today's."""
    day = plan.workspace.clones_day
    if not day:
        return shell.NOTHING
    return shell.Around(
        before=f"# What CMake clones without a commit is of {quote.checked(day)}\n{shell.copy_script('git-as-of')}",
        first=(
            f"mkdir --parents {_FOLDER}",
            f'ln -sf "$(command -v git-as-of)" {_FOLDER}/git',
            f'export GIT_AS_OF={quote.shell(day)} PATH="{_FOLDER}:${{PATH}}"',
        ),
    )
