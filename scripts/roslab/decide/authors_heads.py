"""What an author's old Dockerfile clones at a head: it was of its day; today's may need what the image lacks."""

from __future__ import annotations

from roslab.decide.authors_pip import runs_bash
from roslab.decide.ros.source_names import drifts
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import AuthorDockerfile
from roslab.evidence.prose.python_steps import image_at
from roslab.values.pattern import pattern

_LINE = pattern(r"v?\d+(?:\.\d+)*\.x")
"""A branch of releases by its name: ``4.x``."""


def at_head(git: GitSource) -> bool:
    """Tell whether a clone is of the newest commit of a branch."""
    ref = git.ref or ""
    return not ref or drifts(ref) or bool(_LINE.fullmatch(ref))


def heads_of_the_day(authored: AuthorDockerfile, day: str) -> dict[str, str]:
    """Return the external images in which a head is cloned, each with why it is of a day.

    git under another name is given to the shell that runs the steps: what ``authors_pip`` leaves as it is, this does.
    """
    found: dict[str, str] = {}
    for git in () if authored.own_shell else authored.clones:
        name = image_at(git.line, authored.stages)
        if name not in found and not git.removed and at_head(git) and runs_bash(name):
            at = f"at its branch {git.ref}" if git.ref else "without a tag or a commit"
            found[name] = f"line {git.line} clones {git.url} {at}: it takes that of {day}"
    return found
