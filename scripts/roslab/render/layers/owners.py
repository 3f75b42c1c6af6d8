"""What root made and the image's user owns: files in its home, and the environment of Python."""

from __future__ import annotations

from roslab.plan.plan import Plan

_ENVIRONMENTS = {"venv": "/opt/venv", "conda": "/opt/conda"}
"""The folder of each kind of environment that is not the system's."""


def own_projects(plan: Plan) -> str:
    """Give the user what pip wrote beside the projects that root installed, and the environment with the rest of it."""
    return "\n".join(filter(None, (own_home(plan), _environment(plan)))) if plan.workspace.python_projects else ""


def environment_without_projects(plan: Plan) -> str:
    """Give the user the environment where no project comes into it with the source."""
    return "" if plan.workspace.python_projects else _environment(plan)


def own_home(_: Plan) -> str:
    """Give the user what root made in its home; files that are its own already are not written to the layer again."""
    why = "# What root made in the user's home\n"
    return (
        why + 'RUN find "/home/${NB_USER}" ! -user "${NB_UID}" -exec chown --no-dereference "${NB_UID}:${NB_UID}" {} +'
    )


def _environment(plan: Plan) -> str:
    """Give the user the folders of an environment that is not the system's, as it has them on its own computer.

    Programs write beside the modules of some packages, and pip there; the files that are there stay root's.
    """
    folder = _ENVIRONMENTS.get(plan.python.manager)
    why = "# The environment is the user's: packages write beside their modules, and pip installs more\n"
    return f'{why}RUN find {folder} -type d -exec chown "${{NB_UID}}:${{NB_UID}}" {{}} +' if folder else ""
