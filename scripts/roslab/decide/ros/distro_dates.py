"""The distribution by date, from release windows: the weakest evidence, but better than none."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import Distro, default_distro, distros

ADOPTED = 365
"""Days from a release until code is written for it: four of four repositories that name one distribution, and whose
last commit fell into the first year of a newer one, had not moved to it."""


def dated(evidence: Evidence) -> Mention | None:
    """Return the newest date that the repository gives."""
    return max((m for m in evidence.mentions if m.topic == "date"), key=lambda m: m.value, default=None)


def of_its_time(kind: Kind, date: str | None) -> str:
    """Return the distribution that code of a date (``YYYY-MM-DD``) was most likely written for.

    The preferred one of those that were a year old and still supported, the default without a date; for a date before
    every release or after every end, the nearest.
    """
    line = [d for d in distros().values() if d.ros == (1 if kind == "ros1" else 2) and d.eol]
    if date is None:
        return default_distro(1 if kind == "ros1" else 2).name
    fitting = [distro for distro in line if _open(distro, date)]
    if fitting:
        return max(fitting, key=lambda distro: distro.preference).name
    line.sort(key=lambda distro: distro.released)
    return (line[0] if date < line[-1].released else line[-1]).name


def supported(name: str, date: str) -> bool:
    """Tell whether a distribution was out, and had not ended, on a date."""
    found = distros()[name]
    return found.eol is not None and found.released <= date <= found.eol


def _open(distro: Distro, date: str) -> bool:
    return later(distro.released, ADOPTED) <= date <= (distro.eol or date)


def later(date: str, days: int) -> str:
    """Return the date that is some days later."""
    import datetime as dt  # noqa: PLC0415 - for trees with a commit

    return (dt.date.fromisoformat(date) + dt.timedelta(days=days)).isoformat()
