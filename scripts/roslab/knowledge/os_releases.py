"""Releases of Ubuntu and Debian: when each ends, where its packages go then, and which of them an image has.

Those of Ubuntu with long support are in ``ubuntu.csv``, all others in ``os_releases.csv``.
"""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.distros import distro, ubuntus
from roslab.knowledge.table import rows
from roslab.values.image import without_tag
from roslab.values.pattern import pattern

_REGISTRY = pattern(r"^(?:docker\.io/)?(?:library/)?")
_ROS = pattern(r"(?:^|/)ros:([a-z]+)")
_UBUNTU = pattern(r"ubuntu[:_-]?(\d\d\.\d\d)")
_DEBIAN = pattern(r"^debian:(\d+)")


@cache
def ends() -> dict[str, str]:
    """Return ``{codename: YYYY-MM-DD}``: the end of the free updates of each release, in the past or to come."""
    others = {row["codename"]: row["ends"] for row in rows("os_releases")}
    return others | {row["codename"]: row["ended"] for row in rows("ubuntu")}


@cache
def has_ended(codename: str | None) -> bool:
    """Tell whether a release was past its end when the table was read; the clock is not asked."""
    known = max(row["date"] for row in (*rows("os_releases"), *rows("ubuntu")))
    return codename is not None and ends().get(codename, known) < known


def release_of(image: str) -> str | None:
    """Return the codename of the Ubuntu or Debian in an image, as far as its name or the table tells."""
    name = _REGISTRY.sub("", image).partition("@")[0]
    if (found := _ROS.search(name)) and (release := distro(found[1])):
        return release.ubuntu  # before the codenames: kinetic, lunar and groovy are names of Ubuntu too
    if found := _UBUNTU.search(name):
        return _versions("Ubuntu").get(found[1]) or ubuntus().get(found[1])
    if found := _DEBIAN.match(name):
        return _versions("Debian").get(found[1])
    words = re.split(r"[:_-]", name.partition(":")[2])
    named = next((word for word in words if word in ends()), None)
    return named or next(
        (row["codename"] for row in rows("image_releases") if pattern(row["pattern"]).fullmatch(name)), None
    )


def of_debian(image: str) -> bool:
    """Tell whether an image is Debian's: its release is, or it is the official one of a language, whatever its tag."""
    name = without_tag(_REGISTRY.sub("", image))
    found = system_of(release_of(image))
    languages = {row["image"] for row in rows("language_images")} - {"ubuntu"}
    return found == "Debian" or (found is None and name in languages)


@cache
def _versions(system: str) -> dict[str, str]:
    return {row["version"]: row["codename"] for row in rows("os_releases") if row["system"] == system}


@cache
def system_of(codename: str | None) -> str | None:
    """Return ``Ubuntu`` or ``Debian`` for a release, ``None`` for one that is not known."""
    if codename in ubuntus().values():
        return "Ubuntu"
    return next((row["system"] for row in rows("os_releases") if row["codename"] == codename), None)


@cache
def moved_to(codename: str) -> tuple[str, str] | None:
    """Return the name and the archive of a release whose packages were moved there, ``None`` for any other."""
    row = next((row for row in rows("os_releases") if row["codename"] == codename and row["moved"] == "yes"), None)
    if row is None:
        return None
    archive = next(each["archive"] for each in rows("archives") if each["system"] == row["system"])
    return f"{row['system']} {row['version']} ({codename})", archive


@cache
def archives() -> str:
    """Return lines ``PATTERN ADDRESS``: addresses of Ubuntu's and Debian's packages, and where the moved ones are."""
    return "".join(f"{row['pattern']} {row['archive']}\n" for row in rows("archives"))
