"""For which platforms the image can exist."""

from __future__ import annotations

from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.decision import Python, Reason
from roslab.evidence.facts import Evidence


@dataclass(frozen=True, kw_only=True, slots=True)
class PlatformChoice:
    """Platforms to build, and ``(platform, why not)`` for those left out."""

    platforms: tuple[str, ...] = ("linux/amd64", "linux/arm64")
    refused: tuple[tuple[str, str], ...] = ()
    reasons: tuple[Reason, ...] = ()


def decide_platforms(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    base_image: str,
    ros_distro: str | None,
    cuda: str | None,
    python: Python,
) -> PlatformChoice:
    """Return the platforms that can exist."""
    del evidence, kind, base_image, ros_distro, cuda, python
    return PlatformChoice(platforms=config.platforms or ("linux/amd64", "linux/arm64"))
