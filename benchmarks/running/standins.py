"""What stands in for a base image: what a plan names, what was really below it, and what that is known to lack."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from roslab.knowledge.released import released, rosdep_keys

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

HERE = Path(__file__).resolve().parent
LABEL = "org.repro-action.stand-in"
"""The label by which an image says that it stands in for another."""


@dataclass(frozen=True, kw_only=True)
class Base:
    """What a plan's base image is, and what really was below its name."""

    name: str
    ubuntu: str | None
    """Code name of the Ubuntu that the plan takes."""
    python: str | None
    """The plan's Python."""
    stand_in: str = ""
    """``Debian 12``; ``""`` if it is the real image."""
    lacking: frozenset[str] = frozenset()
    """ROS packages and keys of rosdep that the world has and the stand-in does not."""


@cache
def facts() -> dict[str, Any]:
    """Return what the stand-ins are known to lack."""
    return tomllib.loads((HERE / "standins.toml").read_text(encoding="utf-8"))


def stand_in(image: str) -> str:
    """Return what stands in for an image of the engine, ``""`` if it is the real one."""
    said = _output("docker", "image", "inspect", "--format", f'{{{{index .Config.Labels "{LABEL}"}}}}', image)
    return said.partition(" in the place")[0].strip()


def lacking(image: str, distro: str | None) -> frozenset[str]:
    """Return the ROS packages and keys of rosdep that the world has and this stand-in's tables do not."""
    if not distro:
        return frozenset()
    return (released(distro) | rosdep_keys()) - {name for text in _tables(image, distro) for name in _names(text)}


def _tables(image: str, distro: str) -> Iterable[str]:
    for name in ("stand-in", distro):
        yield _output("docker", "run", "--rm", "--entrypoint", "cat", image, f"/etc/ros/rosdep/{name}.yaml")


def _names(text: str) -> set[str]:
    """Return the keys of a table of rosdep, or the packages of a distribution file, with their repositories."""
    data = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)) if text else {}
    if "repositories" not in data:
        return set(data)
    released = {name: each.get("release", {}) for name, each in data["repositories"].items()}
    return {package for name, each in released.items() if each for package in each.get("packages") or (name,)}


def _output(*words: str) -> str:
    return subprocess.run(words, capture_output=True, text=True, timeout=120, check=False).stdout
