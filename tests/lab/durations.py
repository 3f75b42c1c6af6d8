"""How long each test of the lab took on this machine: what takes longest begins first, so that all end together."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

from .home import home


def known() -> dict[str, float]:
    """Return the seconds that each test took when it last passed, by its node id; empty where none was run yet."""
    try:
        found = json.loads(_file().read_text())
    except (OSError, ValueError):
        return {}
    return {str(test): float(seconds) for test, seconds in found.items()}


def keep(seconds: Mapping[str, float]) -> None:
    """Keep these beside what is known of other tests, where there is a lab.

    The file is replaced at once: another run may read it.
    """
    if not seconds or not home().is_dir():
        return
    part = _file().with_suffix(".part")
    part.write_text(json.dumps({**known(), **seconds}, indent=1, sort_keys=True))
    part.rename(_file())


def _file() -> Path:
    return home() / "durations.json"
