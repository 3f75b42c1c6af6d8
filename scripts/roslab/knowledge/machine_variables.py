"""The variables that tell of the machine on which a program runs, not of the program, and those of every image."""

from __future__ import annotations

from fnmatch import fnmatchcase

from roslab.knowledge.table import rows


def of_one_machine(name: str) -> bool:
    """Tell whether a variable is of one machine: its GPUs, threads, network, keys or paths of its libraries."""
    return any(fnmatchcase(name, row["name"]) for row in rows("machine_variables"))


def of_every_image(name: str) -> bool:
    """Tell whether a variable is set, or may be, in each image and by the setup scripts that its shells source."""
    return any(fnmatchcase(name, row["name"]) for row in rows("image_variables"))
