"""What an image was made of, as roslab.lock keeps it."""

from __future__ import annotations

from typing import Literal

from roslab.values.dataclass import dataclass

NAME = "roslab.lock"
"""The file's name."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Package:
    """A package of apt that is installed."""

    name: str
    version: str
    architecture: str
    source: str
    """Source package that it was built from."""
    origin: str
    """``URL SUITE/COMPONENT`` that served this version, ``""`` where none served it any more."""
    step: str
    """Step of the Dockerfile that installed it: ``base`` for the base's own, ``""`` where that is not known."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Distribution:
    """A package of Python that pip installed."""

    name: str
    version: str
    hashes: tuple[str, ...]
    """``sha256:…`` of the file that the index gives for it; empty where it is not known, or it comes from git."""
    url: str
    """Where it came from if not from an index, with the commit; ``""`` for an index."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Environment:
    """The packages of one Python of the image."""

    name: str
    """``image`` for the default one, ``jupyter``, ``python2``."""
    packages: tuple[Distribution, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Machine:
    """What one platform's image holds."""

    platform: str
    apt: tuple[Package, ...]
    python: tuple[Environment, ...]
    conda: tuple[str, ...]
    """URL of each package of the conda environment, with ``#`` and its MD5 sum, as conda's explicit files have it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class LockedSource:
    """A repository that was cloned into the image."""

    name: str
    url: str
    commit: str


@dataclass(frozen=True, kw_only=True, slots=True)
class Material:
    """An image or a file that an author's own Dockerfile took from elsewhere."""

    source: str
    """As BuildKit names it: ``docker-image://docker.io/library/ubuntu:24.04``, or the file's URL."""
    digest: str


@dataclass(frozen=True, kw_only=True, slots=True)
class Lock:
    """A whole roslab.lock."""

    base: str
    """Image of the FROM line, without a digest."""
    digest: str
    python: str
    """Manager of Python's packages and the Python that the plan names."""
    rosdistro: str | None
    """Commit or tag of ros/rosdistro whose tables resolved the keys."""
    tools: tuple[tuple[str, str], ...]
    """Name and version of what built the image."""
    sources: tuple[LockedSource, ...]
    machines: tuple[Machine, ...]
    materials: tuple[Material, ...] = ()
    """Only of an author's own Dockerfile."""

    def machine(self, platform: str) -> Machine | None:
        """Return what is known of a platform."""
        return next((machine for machine in self.machines if machine.platform == platform), None)


@dataclass(frozen=True, kw_only=True, slots=True)
class Missing:
    """Something of a lock that can no longer be had."""

    kind: Literal["base", "apt", "pip", "conda", "source"]
    name: str
    wanted: str
    """The version, digest, commit or URL of the lock."""
    nearest: str | None
    """What is left in its place, ``None`` if nothing is."""

    def __str__(self) -> str:
        left = f"the nearest left is {self.nearest}" if self.nearest else "nothing of that name is left"
        return f"{self.kind}: {self.name} {self.wanted} can no longer be had; {left}"
