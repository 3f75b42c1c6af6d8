"""docker_build.sh: builds the image and needs only docker."""

from __future__ import annotations

from roslab.plan.author_dockerfile import AuthorDockerfile
from roslab.plan.plan import Plan
from roslab.render.bases import stage_name
from roslab.render.output import Beside
from roslab.render.script import script

OLDEST_DOCKER = "23"
"""The first version that reads heredocs and ``<Dockerfile>.dockerignore`` without a ``# syntax`` line."""


def text(plan: Plan, beside: Beside) -> str:
    """Return docker_build.sh for the folder it is written to."""
    return build_script(plan, context=beside.context)


def build_script(plan: Plan, *, context: str) -> str:
    """Return the script's text; ``context`` is the repository, relative to the folder the script is written to.

    An author's own Dockerfile is built unchanged and may use everything that docker offers.
    """
    authored = plan.author_dockerfile
    return script(
        "docker_build.sh",
        {
            "image": plan.name,
            "dockerfile": f"{context}/{authored.dockerfile}" if authored else "Dockerfile",
            "context": f"{context}/{authored.context}" if authored else context,
            "oldest_docker": "0" if authored and not authored.bases else OLDEST_DOCKER,
            "bases": _bases(authored),
            "options": _options(authored) if authored else (),
            "secrets": [(name,) for name in plan.secrets],
        },
    )


def _bases(authored: AuthorDockerfile | None) -> list[tuple[str, str]]:
    found = authored.bases if authored else ()
    return [(stage_name(number), base.name) for number, base in enumerate(found, 1)]


def _options(authored: AuthorDockerfile) -> list[tuple[str, str]]:
    target = [("--target", authored.target)] if authored.target else []
    return [*(("--build-arg", f"{name}={value}") for name, value in authored.args), *target]
