"""What the world offers of a past day: package snapshots, ROS's syncs, rosdep's tables, Pythons."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Sync:
    """A sync of a ROS distribution: the day on which its packages were last released together."""

    day: str
    snapshot: bool
    """snapshots.ros.org took one; only distributions with long support have them."""


@cache
def _syncs() -> dict[str, tuple[dict[str, str], ...]]:
    """Return the rows of each distribution, the oldest day first."""
    found = grouped((row["distro"], row) for row in rows("ros_syncs"))
    return {name: tuple(sorted(syncs, key=lambda row: row["day"])) for name, syncs in found.items()}


def last_sync(distro: str, day: str) -> Sync | None:
    """Return the last sync of a distribution not after a day (``YYYY-MM-DD``), ``None`` if none is known."""
    row = next((row for row in reversed(_syncs().get(distro, ())) if row["day"] <= day), None)
    return Sync(day=row["day"], snapshot=row["snapshot"] == "yes") if row else None


def rosdistro_ref(distro: str, day: str) -> tuple[str, str]:
    """Return the ref of ros/rosdistro with the tables of a day, and the day that they are of.

    The tag of the distribution's last sync, else of any other's, for the tables are of all; before the first tag the
    last commit of a month; before the first with today's index, it.
    """
    if sync := last_sync(distro, day):
        return f"{distro}/{sync.day}", sync.day
    others = [(found.day, name) for name in _syncs() if (found := last_sync(name, day))]
    if others:
        newest, name = max(others)
        return f"{name}/{newest}", newest
    table = rows("rosdistro_commits")
    row = next((row for row in reversed(table) if row["day"] <= day), table[0])
    return row["commit"], row["day"]


def archives_of(day: str, system: str | None) -> tuple[tuple[str, str], ...]:
    """Return ``(pattern of an address, address of its snapshot)`` of the archives that can be had as of a day.

    ``system`` is Ubuntu or Debian, ``None`` for one that is not known.
    """
    time = f"{day.replace('-', '')}T235959Z"
    known = (row for row in rows("snapshots") if row["since"] <= day and system in (None, row["system"]))
    return tuple((row["pattern"], row["address"].format(time=time)) for row in known)


def since(system: str) -> str:
    """Return the first day of the snapshots of Ubuntu or Debian."""
    return min(row["since"] for row in rows("snapshots") if row["system"] == system)


@cache
def long_ago() -> str:
    """Return the day before which a commit is old: a year before the newest day that these tables know.

    The program has no clock, so that a checkout has one plan; its tables are read again with each release.
    """
    newest = max(syncs[-1]["day"] for syncs in _syncs().values())
    return f"{int(newest[:4]) - 1}{newest[4:]}"


def usual(python: str, day: str) -> bool:
    """Tell whether a Python 3 had been out for a year on a day: by then packages had wheels for it."""
    return python.startswith("3") and existed(python, f"{int(day[:4]) - 1}{day[4:]}")


def existed(python: str, day: str) -> bool:
    """Tell whether a Python (``3.8``) had been released on a day; one that is not in the table counts as new."""
    return any(row["python"] == python and row["released"] <= day for row in rows("pythons"))


def ended(python: str, day: str) -> bool:
    """Tell whether a Python had no support any more on a day; of most the table does not tell it."""
    return any(row["python"] == python and "" < row["ended"] <= day for row in rows("pythons"))
