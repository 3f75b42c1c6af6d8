"""The author's own Dockerfile, where it is built instead of a generated one."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.plan.author_bases import Base, author_bases
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class AuthorDockerfile:
    """The author's own Dockerfile, built instead of a generated one; paths relative to the root."""

    dockerfile: str
    context: str
    args: tuple[tuple[str, str], ...] = ()
    """Build arguments."""
    target: str | None = None
    """The stage to build; ``None`` for the last one."""
    bases: tuple[Base, ...] = ()
    """Images that it starts from and that the build replaces, as named contexts."""


def author_dockerfile(decision: Decision, config: Config) -> AuthorDockerfile | None:
    """Return the Dockerfile that was chosen, with what roslab.yaml says of its build; ``None`` for a generated one."""
    if not decision.dockerfile:
        return None
    return AuthorDockerfile(
        dockerfile=decision.dockerfile,
        context=decision.context or ".",
        args=config.args,
        target=config.target,
        bases=author_bases(decision),
    )
