"""Sister packages and clones in the tree, changed by patches of the repository."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import patches, shell
from roslab.render.layers.workspace import WS, source_folder


def of_clones(plan: Plan) -> str:
    """Apply them to sister packages and to what is cloned into the tree, as the user, who owns these."""
    place = plan.workspace
    clones = [(f"{WS}/src/{source.name}", source) for source in place.sources]
    clones += [(f"{source_folder(plan)}/{source.name}", source) for source in place.submodules]
    runs = [
        shell.run(*patches.applied(source, quote.shell_with_user(folder)), secrets=patches.mounted(source))
        for folder, source in clones
        if source.patches
    ]
    if not runs:
        return ""
    return "\n".join(["# Patches of the repository, as its author applies them", "USER ${NB_USER}", *runs, "USER root"])
