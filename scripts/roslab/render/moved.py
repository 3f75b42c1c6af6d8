"""What moved between two images, as text and as JSON."""

from __future__ import annotations

import dataclasses
import json

from roslab.lock.comparison import KINDS, Change, Comparison

TITLES = {
    "base": "the base",
    "apt": "packages of apt",
    "pip": "packages of pip",
    "conda": "packages of conda",
    "source": "cloned repositories",
    "env": "variables",
}


def text(found: Comparison) -> str:
    """Return what moved, a line for each thing, and how many packages of all did."""
    lines = [f"{len(found.moved)} of {found.packages} packages moved"]
    for kind in KINDS:
        changes = [change for change in found.changes if change.kind == kind]
        if changes:
            lines.append(f"{TITLES[kind]}:")
            lines += [f"  {line(change)}" for change in changes]
    old, new = found.sizes
    if old and new and old != new:
        lines.append(f"size: {old / 1e6:.1f} MB, then {new / 1e6:.1f} MB")
    return "\n".join(lines) + "\n"


def line(change: Change) -> str:
    """Return one change in words."""
    if change.old is None:
        return f"{change.name}: new, {change.new}"
    if change.new is None:
        return f"{change.name}: gone, it was {change.old}"
    return f"{change.name}: {change.old}, then {change.new}"


def to_json(found: Comparison) -> str:
    """Return the comparison as JSON."""
    data = {
        "packages": found.packages,
        "moved": len(found.moved),
        "sizes": list(found.sizes),
        "changes": [dataclasses.asdict(change) for change in found.changes],
    }
    return json.dumps(data, indent=2) + "\n"
