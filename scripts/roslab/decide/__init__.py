"""Evidence, configuration and knowledge → one decision per question, each with its reasons."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roslab.config.model import Config
    from roslab.decide.decision import Decision
    from roslab.evidence.facts import Evidence


def decide(evidence: Evidence, config: Config, *, folder_name: str) -> Decision:
    """Answer every question about a repository; ``folder_name`` is its name if nothing else gives one.

    roslab.yaml and the action's inputs, already one ``Config``, win over the evidence, which wins over defaults.
    Raises ``NothingToBuildError`` where there is nothing to decide on.
    """
    # Most steps of a workflow read a plan that another one made: its types alone lie in modules of this room
    from roslab.decide.deciding import decide as answered  # noqa: PLC0415

    decision = answered(evidence, config, folder_name=folder_name)
    if decision.may_fail and decision.kind in {"ros1", "ros2"}:
        from roslab.decide.hopeless import without_hopeless  # noqa: PLC0415 - few trees lack what their code needs

        if other := without_hopeless(decision, evidence, config):
            return answered(other, config, folder_name=folder_name)
    if decision.left_out and decision.kind == "ros2":
        from roslab.decide.hopeless import starts_whole, without_stopping  # noqa: PLC0415 - as above

        if other := without_stopping(decision, evidence, config):
            instead = answered(other, config, folder_name=folder_name)
            return instead if starts_whole(instead, other) else decision
    return decision
