"""Requirement files of submodules: the image clones them before its Python packages are installed."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import caches, python, secrets, shell
from roslab.render.layers.workspace import source_folder


def install(plan: Plan) -> str:
    """Install what the files name; nothing has read them, so that no line of them stops the build."""
    if not plan.python.cloned_files:
        return ""
    files = "".join(f" {quote.shell_with_user(f'{source_folder(plan)}/{name}')}" for name in plan.python.cloned_files)
    options = f"{caches.pip_option(plan)}{python.pip_options(plan.python.options)}"
    return shell.call(
        "install-cloned-files",
        f" {python.interpreter(plan)} {options} --{files}",
        comment="Requirement files of submodules, which could not be read before",
        before=shell.copy_script("install-optional-pip"),
        secrets=secrets.for_tries_of_pip(plan),
    )
