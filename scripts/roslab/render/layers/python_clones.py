"""Clones in the workspace that are plain Python: pip installs them with what they need."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import caches, python, secrets, shell
from roslab.render.layers.workspace import WS


def install(plan: Plan) -> str:
    """Install those without a package.xml, after the packages that are declared: one may compile against torch."""
    folders = [quote.shell_with_user(f"{WS}/src/{each.name}") for each in plan.workspace.sources if each.imported]
    if not folders:
        return ""
    options = f"{caches.pip_option(plan)}{python.pip_options(plan.python.options)}"
    guessed = bool(plan.python.pip_guessed)
    return shell.call(
        "install-python-clones",
        f" {python.interpreter(plan)} {options} --{''.join(f' {each}' for each in folders)}",
        comment="Clones without a package.xml that are plain Python: colcon would install nothing that they need",
        before="" if guessed else shell.copy_script("install-optional-pip"),
        secrets=secrets.for_tries_of_pip(plan),
    )
