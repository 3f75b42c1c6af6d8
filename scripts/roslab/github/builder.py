"""The builder of a job: its driver, and the platforms for which the machine needs an emulator."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from roslab.engine import native_platform, output


def settings(environment: Mapping[str, str]) -> dict[str, str]:
    """Return the inputs ``driver`` and ``endpoint`` of docker/setup-buildx-action.

    A runner gets a BuildKit of its own in a container. A machine that has one already names it with
    ROSLAB_BUILDX_DRIVER (``remote``) and ROSLAB_BUILDX_ENDPOINT (``unix:///…``): https://docs.docker.com/build/builders/drivers/
    """
    return {
        "driver": environment.get("ROSLAB_BUILDX_DRIVER") or "docker-container",
        "endpoint": environment.get("ROSLAB_BUILDX_ENDPOINT", ""),
    }


def emulated(platforms: Sequence[str]) -> tuple[str, ...]:
    """Return the architectures that the machine cannot run yet, as docker/setup-qemu-action names them."""
    known = listed(output(["docker", "buildx", "inspect", "default"]).stdout) or (native_platform(),)
    lacking = [platform for platform in platforms if platform not in known]
    return tuple(dict.fromkeys(platform.split("/")[1] for platform in lacking))


def listed(inspection: str) -> tuple[str, ...]:
    """Return the platforms that ``docker buildx inspect`` lists; a star marks preferred ones."""
    lines = re.findall(r"^\s*Platforms:\s*(.+)$", inspection, flags=re.MULTILINE)
    return tuple(part.strip().rstrip("*") for line in lines for part in line.split(",") if part.strip())
