"""conda environments by what they hold, whatever their file is called: ``ifeel_demo/pinn-toy.yml``."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.evidence import places
from roslab.repository.checkout import File
from roslab.values.conda import conda_package

_KEYS = frozenset(
    {"name", "channels", "channel_priority", "dependencies", "prefix", "variables", "platforms", "category"}
)
"""The keys that conda and its kin read; another one is of ROS, Helm, Compose or a recipe.

https://docs.conda.io/projects/conda/en/stable/dev-guide/specs/environment.html, 2026-11-27.
"""
MAX_SIZE = 32 * 1024
"""Most bytes of a file that is read for its content alone."""


def looked_at(file: File) -> bool:
    """Tell whether a file of an unusual name is read: one at the root or just below, not of tests, CI or pages."""
    path = file.path
    apart = path.startswith(".") or places.test(path) or places.documentation(path) or places.vendored(path)
    return path.count("/") <= 1 and file.size <= MAX_SIZE and not apart


def shaped(text: str) -> bool:
    """Tell, before it is parsed, whether a text may be an environment."""
    text = f"\n{text}"
    return "\ndependencies:" in text and ("\nchannels:" in text or "\nname:" in text)


def is_environment(data: object) -> bool:
    """Tell whether a parsed file is one that ``conda env create`` reads, and nothing else.

    It lists packages, and names its channels; one without channels has a name, and Python or pip among the packages.
    """
    if not isinstance(data, Mapping) or not _KEYS.issuperset(data):
        return False
    entries = data.get("dependencies")
    if not isinstance(entries, list) or not entries:
        return False
    named = [conda_package(entry) for entry in entries if isinstance(entry, str)]
    packages = {package.name for package in named if package}
    inner = any(isinstance(entry, Mapping) and isinstance(entry.get("pip"), list) for entry in entries)
    if isinstance(data.get("channels"), list):
        return bool(packages) or inner
    return isinstance(data.get("name"), str) and (inner or not packages.isdisjoint({"python", "pip"}))
