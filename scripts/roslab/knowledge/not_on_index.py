"""Names that people require although pip's index lacks them, or has only a placeholder that raises an error."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.released import ever_released
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern

_ONLY_OF_ROS = pattern(r".+-(?:msgs|srvs|interfaces)|rqt-.+")
"""Messages and the parts of rqt: where ROS released one, the index has none."""
_WHY = "it is a package of ROS's"


@dataclass(frozen=True, kw_only=True, slots=True)
class NotOnIndex:
    """What to install instead (``""`` where nothing can be), and why."""

    instead: str
    releases: str
    """``same`` where that has the same versions, so that what is said of them holds for it, too; of a repository how it
    calls the tag of a version: ``v{}``."""
    why: str
    conda: tuple[str, ...]
    """conda's channels that have it."""
    needs: tuple[str, ...]
    """What its modules import, where its own list has what pip cannot install: it is installed without that list."""
    unpacked: str
    """The folder that pip installs of an archive which nobody can fetch without an account, as the archive has it."""
    source: str
    """Where its author tells how to install it."""


@cache
def not_on_index() -> dict[str, NotOnIndex]:
    """Return the table by normalised name."""
    return {canonicalize_name(row["pip"]): record(NotOnIndex, row) for row in rows("not_on_index")}


@cache
def of_ros(name: str) -> NotOnIndex | None:
    """Return the row of a package of ROS by normalised name: the index has none, or another thing of the name."""
    if found := _of_ros().get(name):
        return found
    if not _ONLY_OF_ROS.fullmatch(name) or not ever_released(name.replace("-", "_")):
        return None
    return _row_of_ros("https://github.com/ros/rosdistro")


@cache
def _of_ros() -> dict[str, NotOnIndex]:
    return {canonicalize_name(row["pip"]): _row_of_ros(row["source"]) for row in rows("of_ros")}


def _row_of_ros(source: str) -> NotOnIndex:
    return NotOnIndex(instead="", releases="", why=_WHY, conda=(), needs=(), unpacked="", source=source)
