"""What CMake clones without a commit is of a day: git under another name comes before git itself."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell


def of_day(plan: Plan) -> shell.Around:
    """Return what a step needs so that what it clones without a commit is of the plan's day, nothing for today's."""
    day = plan.workspace.clones_day
    if not day:
        return shell.NOTHING
    return shell.Around(
        before=f"# What CMake clones without a commit is of {quote.checked(day)}\n{shell.copy_script('git-as-of')}",
        first=(f'eval "$(git-as-of {quote.shell(day)})"',),
    )
