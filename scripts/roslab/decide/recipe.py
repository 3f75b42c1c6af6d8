"""Whether the author's own Dockerfile can be believed."""

from __future__ import annotations

from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.decision import Reason, Warning_
from roslab.evidence.facts import Evidence


@dataclass(frozen=True, kw_only=True, slots=True)
class RecipeChoice:
    """A Dockerfile of the tree and its build context, both relative to the root; ``None`` to generate one."""

    dockerfile: str | None = None
    context: str | None = None
    reasons: tuple[Reason, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def decide_recipe(evidence: Evidence, config: Config, kind: Kind, ros_distro: str | None) -> RecipeChoice:
    """Return the author's recipe where it can be believed."""
    del evidence, kind, ros_distro
    return RecipeChoice(dockerfile=config.dockerfile, context=config.context)
