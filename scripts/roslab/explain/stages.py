"""What the log of a build says of the stage that a step belongs to."""

from __future__ import annotations

from roslab.explain.steps import Log, Step
from roslab.values.pattern import pattern

_HUB = pattern(r"(?<=\s)docker\.io/(?:library/)?")
_DIGEST = pattern(r"@sha256:[0-9a-f]{1,64}")
_STAGE = pattern(r"^\[((?:[\w./-]{1,100} ){0,2})\d{1,3}/\d{1,3}\]")


def user(log: Log, step: Step) -> str:
    """Return the USER instruction that a step runs under, ``""`` if the log shows none in its stage."""
    stage = _stage(step)
    for earlier in log.before(step):
        if _stage(earlier) == stage and earlier.command.startswith(("USER ", "FROM ")):
            return earlier.command if earlier.command.startswith("USER ") else ""
    return ""


def base(log: Log, step: Step) -> str:
    """Return the FROM instruction of a step's stage as a Dockerfile has it, ``""`` if the log does not show it."""
    stage = _stage(step)
    for earlier in log.before(step):
        if not earlier.command.startswith("FROM ") or _stage(earlier) != stage:
            continue
        words = _DIGEST.sub("", _HUB.sub("", earlier.command)).split()
        named = stage.split()[-1:]
        if named and "/" not in named[0] and not named[0].startswith("stage-"):
            words += ["AS", named[0]]
        return " ".join(words)
    return ""


def _stage(step: Step) -> str:
    """Return what a step's name says before its number: BuildKit names the platform and the stage, Docker nothing."""
    found = _STAGE.match(step.name)
    return found[1].strip() if found else ""
