"""Clones in the workspace that are plain Python: pip installs them with what they need."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import caches, python, secrets, shell
from roslab.render.layers.workspace import WS
from roslab.values.name import canonicalize_name


def install(plan: Plan) -> str:
    """Install those without a package.xml, after the packages that are declared: one may compile against torch."""
    names = [each.name for each in plan.workspace.sources if each.imported]
    if not names:
        return ""
    by_name = {canonicalize_name(asked) for asked in plan.python.pip_guessed}
    folders = [
        f"{'--instead=' if canonicalize_name(name) in by_name else ''}{quote.shell_with_user(f'{WS}/src/{name}')}"
        for name in names
    ]
    options = f"{caches.pip_option(plan)}{python.pip_options(plan.python.options)}"
    guessed = bool(plan.python.pip_guessed)
    return shell.call(
        "install-python-clones",
        f" {python.interpreter(plan)} {options} --{''.join(f' {each}' for each in folders)}",
        comment="Clones without a package.xml that are plain Python: colcon would install nothing that they need",
        before="" if guessed else shell.copy_script("install-optional-pip"),
        secrets=secrets.for_tries_of_pip(plan),
    )
