"""Which tags a proved image gets: always its commit's own; the others only if they move forward."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from roslab.config.model import TagParts
from roslab.errors import ConfigurationError, Problem
from roslab.github.event import Event
from roslab.plan.plan import SLIM
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

OWN = pattern(r"sha-[0-9a-f]{7,40}")
"""The tag of one commit in the form of docker/metadata-action."""
RESERVED = pattern(
    r"latest|nightly|v?\d+|(?:v\d+|\d+\.\d+|v\d+\.\d+|v?\d+\.\d+\.\d+)(?:[-+].*)?|sha-[0-9a-f]{7,40}|buildcache-.*|pr-\d+"
)
"""Tags that mean a release, a commit, a cache or a pull request, which a branch of that name must not take."""
TAKEN = pattern(r"latest|nightly|sha-[0-9a-f]{7,40}|buildcache-.*|pr-\d+")
"""The same for a git tag, which may have the name of a release."""
SLIM_ENDING = f"-{SLIM}"
SERIES = pattern(r"\d+\.\d+")
RELEASE = pattern(r"v?(\d+)\.(\d+)\.(\d+)")


@dataclass(frozen=True, kw_only=True, slots=True)
class Chosen:
    """The tags that move to an image, as complete references, and notes on those that do not."""

    moving: tuple[str, ...]
    warnings: tuple[str, ...] = ()


def own(said: str, image: str, event: Event) -> str:
    """Return the commit's tag from those that docker/metadata-action named, one complete reference per line.

    This tag is made first, so that it exists when it is signed; no other commit has it. A pull request has one tag
    instead, which moves with it: its merge commits are in no history. Raises ``ConfigurationError`` if there is none.
    """
    if event.proposed:
        return f"{image}:pr-{event.pull}"
    names = _names(said, image)
    found = [name for name in names if _is_own(name, event)]
    if not found:
        raise ConfigurationError(
            Problem(message=f"no tag sha-{event.sha[:7]} of {image} is among {', '.join(names) or 'none'}")
        )
    return f"{image}:{found[0]}"


def chosen(said: str, image: str, event: Event, *, head: str | None, releases: Iterable[str] = ()) -> Chosen:
    """Choose which of the other tags move.

    ``head`` is the commit that the branch points to on GitHub now, ``None`` if it does not exist; ``releases`` are the
    names of the repository's git tags; a pull request has no other tags. Raises ``ConfigurationError`` for a tag of
    another image.
    """
    if event.proposed:
        return Chosen(moving=())
    moving = [name for name in _names(said, image) if not _is_own(name, event)]
    warnings: list[str] = []
    reference = event.branch or event.tag or ""
    taken = cleaned(reference)
    wanted = taken == "latest" and event.branch == event.default_branch
    if (RESERVED if event.branch else TAKEN).fullmatch(taken) and taken in moving and not wanted:
        moving.remove(taken)
        what = "branch" if event.branch else "git tag"
        warnings.append(f"the {what} {reference} gets no tag of its name: {taken} means something else in a registry")
    if event.tag and taken in moving and taken == cleaned(event.default_branch):
        moving.remove(taken)
        warnings.append(f"the git tag {reference} gets no tag of its name: that is the default branch's")
    if event.branch and moving and head != event.sha:
        now = f"is at {head[:12]} now" if head else "is gone"
        warnings.append(f"{', '.join(moving)}: not moved to {event.sha[:12]}, since the branch {reference} {now}")
        moving = []
    if event.tag and (later := _later(event.tag, releases)):
        behind = [name for name in moving if SERIES.fullmatch(name)]
        moving = [name for name in moving if name not in behind]
        warnings += [f"{name}: not moved back to {event.tag}, since {later} is newer" for name in behind]
    return Chosen(moving=tuple(f"{image}:{name}" for name in moving), warnings=tuple(warnings))


def dressed(reference: str, parts: TagParts) -> str:
    """Return a reference whose tag has the caller's prefix and suffix.

    A tag has at most 128 characters: https://github.com/distribution/reference/blob/main/regexp.go
    """
    image, _, name = reference.rpartition(":")
    kept = name[: 128 - len(parts.prefix) - len(parts.suffix)]
    return f"{image}:{parts.prefix}{kept}{parts.suffix}"


def of_slim(whole: TagParts) -> TagParts:
    """Return what the tags of the slim image begin and end with."""
    return TagParts(prefix=whole.prefix, suffix=whole.suffix + SLIM_ENDING)


def _is_own(name: str, event: Event) -> bool:
    """Return whether a tag is that of the event's commit; a branch may be named like another commit's tag."""
    return bool(OWN.fullmatch(name)) and event.sha.startswith(name.removeprefix("sha-"))


def _names(said: str, image: str) -> Sequence[str]:
    references = tuple(dict.fromkeys(line.strip() for line in said.splitlines() if line.strip()))
    strange = [reference for reference in references if reference.rpartition(":")[0] != image]
    if strange:
        raise ConfigurationError(Problem(message=f"tags of {image} were expected, not {', '.join(strange)}"))
    return [reference.rpartition(":")[2] for reference in references]


def cleaned(name: str) -> str:
    """Return a branch or git tag in the form that docker/metadata-action gives it in a tag."""
    return re.sub(r"[^a-zA-Z0-9._-]+", "-", name)


def _later(tag: str, releases: Iterable[str]) -> str | None:
    """Return a release of the same series, MAJOR.MINOR, with a higher patch number; ``None`` if there is none."""
    own = RELEASE.fullmatch(tag)
    if not own:
        return None
    found = [
        match for name in releases if (match := RELEASE.fullmatch(name)) and match.groups()[:2] == own.groups()[:2]
    ]
    newest = max(found, key=lambda match: int(match[3]), default=own)
    return newest[0] if int(newest[3]) > int(own[3]) else None
