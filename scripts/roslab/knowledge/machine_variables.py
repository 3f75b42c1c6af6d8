"""The variables that tell of the machine on which a program runs, not of the program, and those of every image."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import named_by


def of_one_machine(name: str) -> bool:
    """Tell whether a variable is of one machine: its GPUs, threads, network, keys or paths of its libraries."""
    return bool(_names("machine_variables").match(name))


def of_every_image(name: str) -> bool:
    """Tell whether a variable is set, or may be, in each image and by the setup scripts that its shells source."""
    return bool(_names("image_variables").match(name))


@cache
def _names(table: str) -> re.Pattern[str]:
    return named_by(row["name"] for row in rows(table))
