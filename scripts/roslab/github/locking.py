"""What a run does with the lock of a repository before it builds."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.errors import Problem
from roslab.github import workflow
from roslab.lock import check
from roslab.plan.lock import NAME, without
from roslab.plan.plan import Plan
from roslab.render.dockerfile import question


def available(plan: Plan, platforms: Sequence[str]) -> Plan:
    """Return the plan without what its lock names and nobody has any more; each is told before the build."""
    if plan.lock is None or plan.author_dockerfile:
        return plan
    for platform in platforms:
        with workflow.group(f"Ask for what {NAME} names, for {platform}"):
            answer = check.check(plan, question(plan), platform)
        for said in answer.silent:
            workflow.say(said)
        for each in answer.missing:
            workflow.warn(Problem(message=f"{NAME}: {each}"))
        plan = without(plan, answer.missing)
    return plan
