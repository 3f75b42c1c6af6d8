"""Which requirements hold in an image: their markers, evaluated with its Python and its platforms."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import TYPE_CHECKING

from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement
from roslab.values.specifier import NEWEST_PATCH

if TYPE_CHECKING:
    from packaging.markers import Marker

_MACHINES = {"linux/amd64": "x86_64", "linux/arm64": "aarch64", "linux/arm/v7": "armv7l", "linux/386": "i686"}
"""``uname -m`` on each platform; for others it is the last part of the platform's name.

https://github.com/containerd/platforms/blob/main/platforms.go, read 2026-11-21."""
_UNKNOWN = ("platform_release", "platform_version")
"""Markers about the kernel, which is that of the machine the image runs on."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Interpreter:
    """Every Python (``3.8``) that an image may have, and every platform it is built for."""

    pythons: tuple[str, ...]
    platforms: tuple[str, ...] = ("linux/amd64", "linux/arm64")

    def on(self, *platforms: str) -> Interpreter:
        """Return the same Pythons, on these platforms only."""
        return Interpreter(pythons=self.pythons, platforms=platforms)

    def may(self, requirement: Requirement) -> bool:
        """Tell whether pip installs it for at least one Python and platform."""
        return any(holds is not False for holds in self._cases(requirement))

    def must(self, requirement: Requirement) -> bool:
        """Tell whether pip installs it for every Python and platform."""
        return all(self._cases(requirement))

    def _cases(self, requirement: Requirement) -> Iterable[bool | None]:
        if requirement.marker is None:
            return (True,)
        said = str(requirement.marker)  # once: a marker writes itself anew for its hash and to be compared, too
        _markers().setdefault(said, requirement.marker)
        return (_holds(said, python, on) for python in self.pythons for on in self.platforms)


@cache
def _markers() -> dict[str, Marker]:
    """Return what keeps the markers by their texts, so that none is parsed again."""
    return {}


@cache
def _holds(said: str, python: str, platform: str) -> bool | None:
    """Evaluate a marker; ``None`` if it depends on the machine that the image will run on."""
    from roslab.values.standard_requirement import UndefinedComparison  # noqa: PLC0415 - a marker has imported it

    if any(name in said for name in _UNKNOWN):
        return None
    full = f"{python}.{NEWEST_PATCH}"
    environment = {
        "implementation_name": "cpython",
        "implementation_version": full,
        "os_name": "posix",
        "platform_machine": _MACHINES.get(platform, platform.rpartition("/")[2]),
        "platform_python_implementation": "CPython",
        "platform_release": "0",
        "platform_system": "Linux",
        "platform_version": "0",
        "python_full_version": full,
        "python_version": python,
        "sys_platform": "linux2" if python.startswith("2") else "linux",
        "extra": "",
    }
    try:
        return _markers()[said].evaluate(environment)
    except UndefinedComparison:
        return None
