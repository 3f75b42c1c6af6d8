"""What the image takes as it was on a day, and what cannot be had of that day."""

from __future__ import annotations

from roslab.config.model import Source
from roslab.decide.decision import Decision, Warning_
from roslab.knowledge import days
from roslab.knowledge.distros import distro
from roslab.knowledge.os_releases import release_of, system_of
from roslab.values.dataclass import dataclass, replace
from roslab.values.redacted import redacted


@dataclass(frozen=True, kw_only=True, slots=True)
class AsOf:
    """The day, and the snapshots of package archives on it."""

    day: str
    """``YYYY-MM-DD``, in UTC and to its end."""
    archives: tuple[tuple[str, str], ...]
    """Extended regular expressions of archives' addresses, each with the address of the snapshot."""


def as_of(decision: Decision) -> AsOf | None:
    """Return what is taken as of the day that the decision names, ``None`` without one."""
    if decision.day is None:
        return None
    return AsOf(day=decision.day, archives=days.archives_of(decision.day, _system(decision)))


def _system(decision: Decision) -> str | None:
    return system_of(decision.ubuntu or release_of(decision.base_image))


def of_day(source: Source, day: str | None) -> Source:
    """Return a source that is cloned as it was on a day; an archive has one state only."""
    return replace(source, before=day) if day and source.repo else source


def lacking(decision: Decision) -> tuple[Warning_, ...]:
    """Return by name what the image has of today although it is to be of a day."""
    day = decision.day
    if day is None:
        return ()
    if decision.dockerfile:
        said = f"the image is to be of {day}: {decision.dockerfile} is built with the packages of today"
        return (Warning_(message=said, file=decision.dockerfile),)
    return tuple(Warning_(message=f"the image is to be of {day}: {what}") for what in _lacking(decision, day))


def _lacking(decision: Decision, day: str) -> list[str]:
    found = [f"the base {decision.base_image} is today's, its packages are changed to those of the day"]
    system = _system(decision)
    if system and day < days.since(system):
        since = days.since(system)
        found = [f"{system} has no snapshot before {since}: its packages, the base's too, are its last ones"]
    release = distro(decision.ros_distro) if decision.kind in ("ros1", "ros2") else None
    if release:
        if release.released > day:
            found.append(f"ROS {release.name} was released on {release.released}, and no older one is known")
        sync = days.last_sync(release.name, day)
        if sync is None or not sync.snapshot:
            found.append(f"no snapshot of ROS {release.name} of that time is known: its packages are its last ones")
        if (tables := days.rosdistro_ref(release.name, day)[1]) > day:
            found.append(f"rosdep's tables are of {tables}, the first that today's rosdep reads")
    if decision.python.manager == "conda":
        found.append("conda's packages have no day: they are today's, as far as nothing pins them")
    found += [f"{redacted(option)} names packages without a day" for option in decision.python.options]
    found += [f"{source.name} is an archive, which has no history" for source in decision.source if source.zip]
    return found
