"""The libraries of the system that Python packages are linked with and do not bring.

They are installed once pip has installed all packages, which alone say what they are linked with.
"""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.plan.python import installs
from roslab.render.layers import locks, python, secrets, shell


def before_source(plan: Plan) -> str:
    """Install them in a layer of its own, where the source brings no packages: its edits do not repeat that."""
    return "" if plan.workspace.python_projects else _install(plan)


def after_projects(plan: Plan) -> str:
    """Install them after the repository's own projects, which bring what only their setup.py knows."""
    return f"USER root\n{installed}" if plan.workspace.python_projects and (installed := _install(plan)) else ""


def _install(plan: Plan) -> str:
    if not (installs(plan.python) or plan.workspace.python_projects) or plan.compatible:
        return ""
    return shell.call(
        "install-wheel-libraries",
        f" {python.interpreter(plan)}",
        comment="Libraries of the system that the Python packages are linked with",
        before=shell.copy_data(("shared-objects.txt",)) + shell.copy_script("install-optional-apt"),
        secrets=secrets.for_apt(plan),
        around=locks.apt(plan, "libraries"),
    )
