"""What robots, worlds, launch files, parameters and programs load and shell scripts start: few package.xml name it."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.dependency import Dependency
from roslab.evidence.ros import (
    controllers,
    gazebo_plugins,
    hardware_plugins,
    image_transports,
    looked_up,
    middlewares,
    ros2_verbs,
    started_by_scripts,
)
from roslab.repository.checkout import Repository

_READERS = (
    gazebo_plugins.read,
    hardware_plugins.read,
    controllers.read,
    image_transports.read,
    ros2_verbs.read,
    started_by_scripts.read,
    looked_up.read,
    middlewares.read,
)


def read(repository: Repository) -> Iterator[Dependency]:
    """Yield what each reader finds, in their order."""
    yield from (each for reader in _READERS for each in reader(repository))
