"""Names of packages of apt that pages keep for long after their authors moved on to a newer Ubuntu."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.decide.ros.distro_dates import dated, later
from roslab.evidence.facts import Evidence
from roslab.knowledge.apt_ubuntus import ubuntus_of

_OUTLIVED = 730
"""Days from the release of what has a tool under its name for Python 3 alone, until a page's old name tells nothing. Of
three repositories that name no distribution of ROS, one of 2021 is for the older one, and of two of 2022 and 2023 one
compiles on the newer alone."""


def outlived(name: str, evidence: Evidence, released: Mapping[str, str]) -> bool:
    """Tell whether the last commit came long after an Ubuntu that no longer has a ``python-x``, but a ``python3-x``.

    ``released``: the day from which each Ubuntu is used.
    """
    date = dated(evidence)
    if date is None or not name.startswith("python-"):
        return False
    having = ubuntus_of(name)
    last = max((day for ubuntu, day in released.items() if ubuntu in having), default="")
    newer = [day for ubuntu, day in released.items() if ubuntu not in having and day > last]
    return bool(newer) and date.value >= later(min(newer), _OUTLIVED)
