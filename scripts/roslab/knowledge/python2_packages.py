"""Ubuntu's packages of modules for Python 2 that have other names than those for Python 3, or that these have not."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.distros import ubuntus_with_python2
from roslab.knowledge.frameworks import imports
from roslab.knowledge.table import rows


@cache
def _table() -> dict[tuple[str, str], str]:
    return {
        (row["module"], ubuntu): row["apt"] for row in rows("python2_packages") for ubuntu in row["ubuntus"].split()
    }


def system_package(module: str, ubuntu: str | None) -> str | None:
    """Return the package of a module for the Python that ROS and programs by ``python`` have on an Ubuntu.

    ``ubuntu`` is ``None`` on Debian bookworm; ``None`` is returned where no table has the module.
    """
    apt = (imports().get(module) or (None, None))[1]
    if ubuntu not in ubuntus_with_python2():
        return apt
    return _table().get((module, ubuntu or "")) or (apt.replace("python3-", "python-") if apt else None)


def of_python2(module: str) -> bool:
    """Tell whether any Ubuntu had a module for Python 2 that those for Python 3 have not, or have by another name."""
    return module in {known for known, _ in _table()}
