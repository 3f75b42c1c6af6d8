"""docker_build.sh: builds the image with nothing but docker."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render.script import script

OLDEST_DOCKER = "23"
"""Its builder reads heredocs and ``<Dockerfile>.dockerignore`` without a ``# syntax`` line."""


def build_script(plan: Plan, *, context: str) -> str:
    """Return the script's text; ``context`` is the repository, relative to the folder the script is written to.

    An author's own recipe is built as it stands, with whatever docker can.
    """
    recipe = plan.recipe
    return script(
        "docker_build.sh",
        {
            "image": plan.name,
            "dockerfile": f"{context}/{recipe.dockerfile}" if recipe else "Dockerfile",
            "context": f"{context}/{recipe.context}" if recipe else context,
            "oldest_docker": "0" if recipe else OLDEST_DOCKER,
        },
    )
