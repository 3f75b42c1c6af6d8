"""Layer 4, the libraries of the system that Python packages are linked with and do not bring."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render.layers import building, locks, python, secrets, shell


def install(plan: Plan) -> str:
    """Install them once pip has installed the packages, which alone say what they are linked with."""
    if not building.installs(plan) or plan.compatible:
        return ""
    return shell.call(
        "install-wheel-libraries",
        f" {python.interpreter(plan)}",
        comment="Libraries of the system that these packages are linked with",
        before=shell.copy_data(("sonames.txt",)) + shell.copy_script("install-optional-apt"),
        secrets=secrets.for_apt(plan),
        around=locks.apt(plan, "libraries"),
    )
