"""What is said about sources: which may change, and which others may not have."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Source
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.dependency import GitSource
from roslab.evidence.ros.vcs import https


def loose(sources: Iterable[Source]) -> tuple[Warning_, ...]:
    """Warn about sources without a ref: a later build may get other code."""
    names = sorted(s.name for s in sources if s.repo and not (s.ref or s.before))
    if not names:
        return ()
    message = f"cloned without a fixed ref: {', '.join(names)}; a later build may get other code"
    return (warn(f"{message}: name a tag or a commit where they are listed, or under source in roslab.yaml"),)


def private(name: str, git: GitSource) -> Warning_:
    """Return the warning about a source that may not be there for everybody."""
    why = "its address has somebody's login" if git.private else "a page calls it private"
    message = (
        f"{name} may not be there for everybody, as {why}: where {https(git.url)} cannot be cloned without a login"
    )
    return warn(f"{message}, it is left out, and what needs it may stop the build", git)


def doubted(name: str, git: GitSource) -> Warning_:
    """Return the warning about a source of which the page itself doubts that it is the one."""
    message = f"{name} is cloned from {https(git.url)}, and left out where it cannot be, but the page says of it"
    return warn(f'{message} "{git.doubt}": if another repository is meant, give it under source in roslab.yaml', git)
