"""Libraries whose headers ask for a standard of C++."""

from __future__ import annotations

from roslab.knowledge.code_limits import version_of
from roslab.knowledge.table import rows
from roslab.values.version import Version


def raised(ubuntu: str | None) -> tuple[tuple[str, str], ...]:
    """Return standards that an Ubuntu's libraries ask for, ``14``, with the names by which CMake and ROS know these.

    The oldest standard is the first; an Ubuntu whose version of a library is not known asks for none.
    """
    found: dict[str, str] = {}
    for row in sorted(rows("cpp_standards"), key=lambda each: each["standard"]):
        version = version_of(row["library"], ubuntu, ros=True) if ubuntu else None
        if version is not None and Version(version) >= Version(row["since"]):
            found[row["standard"]] = f"{found.get(row['standard'], '')} {row['names']}".strip()
    return tuple(found.items())
