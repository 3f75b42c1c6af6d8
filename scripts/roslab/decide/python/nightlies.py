"""Pins to a nightly build that pip's index has dropped: the stable release of that number is installed."""

from __future__ import annotations

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.dropped_nightlies import dropped_nightlies
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

_BUILD = pattern(r"(\d+\.\d+)(?:\.\d+)*\.?dev(\d{4})(\d\d)(\d\d)\d*")


def dropped(asked: Requirement) -> Requirement | None:
    """Return the stable release in place of a nightly build that no index has any more; ``None`` for all others."""
    row = dropped_nightlies().get(asked.key)
    match = _BUILD.fullmatch(asked.release or "") if row and not asked.url else None
    if row is None or match is None or "-".join(match.groups()[1:]) >= row.since:
        return None
    extras = f"[{','.join(asked.extras)}]" if asked.extras else ""
    taken = stated(f"{row.stable}{extras}=={match[1]}.*", asked.origin, asked.file, asked.line)
    return replace(taken, marker=asked.marker, role=asked.role, group=asked.group)


def told(asked: Requirement, taken: Requirement) -> Warning_:
    """Return the warning about one of them."""
    since = dropped_nightlies()[asked.key].since
    message = f"pip's index has no {asked.written} any more, nor any build from before {since}"
    return warn(f"{message}: {taken.written} is installed", asked)
