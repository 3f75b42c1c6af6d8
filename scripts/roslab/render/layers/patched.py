"""Sister packages and clones in the tree, as the author changes them: by patches, and by markers for the build."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Source
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import patches, shell
from roslab.render.layers.workspace import WS, source_folder


def of_clones(plan: Plan) -> str:
    """Change sister packages and what is cloned into the tree, as the user, who owns these."""
    place = plan.workspace
    clones = [(f"{WS}/src/{source.name}", source) for source in place.sources]
    clones += [(f"{source_folder(plan)}/{source.name}", source) for source in place.submodules]
    runs = [
        shell.run(*patches.applied(source, quote.shell_with_user(folder)), secrets=patches.mounted(source))
        for folder, source in clones
        if source.patches
    ]
    runs += [shell.run(*_marked(folder, source)) for folder, source in clones if source.marked]
    if not runs:
        return ""
    return "\n".join(["# What is cloned, as the author changes it", "USER ${NB_USER}", *runs, "USER root"])


def _marked(folder: str, source: Source) -> Iterator[str]:
    """Yield the commands that have every build tool pass over folders of a clone, where these are there."""
    for below in source.marked:
        path = quote.shell_with_user(f"{folder}/{below}".rstrip("/"))
        yield f"if [ -d {path} ]; then touch {path}/CATKIN_IGNORE {path}/COLCON_IGNORE; fi"
