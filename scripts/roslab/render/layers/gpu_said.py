"""The call of what asks for a GPU while it is compiled, and is told that there is one."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.plan.plan import Plan
from roslab.render.layers import shell

SCRIPT = "with-gpu-said"
PATH = f'PYTHONPATH="$({SCRIPT})${{PYTHONPATH:+:${{PYTHONPATH}}}}"'
"""Before a call of pip: the shell calls Python by a function, which calls pip again, and which no script would see."""


def asked(plan: Plan, folder: str) -> bool:
    """Tell whether a setup.py in a folder asks; ``""`` for the root."""
    return (folder or ".") in plan.python.gpu_asked


def script(commands: Iterable[str]) -> tuple[str, ...]:
    """Return the line that brings the script into the stage, if one of the commands calls it."""
    return (shell.copy_script(SCRIPT).rstrip(),) if any(SCRIPT in command for command in commands) else ()
