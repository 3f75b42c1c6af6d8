"""What moved between two images, as text and as JSON."""

from __future__ import annotations

import json

from roslab.lock.comparison import KINDS, Change, Comparison
from roslab.render.markdown import block, code, folded
from roslab.values.dataclass import asdict

MOST = 200
"""Most lines of a proposal."""
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
        "changes": [asdict(change) for change in found.changes],
    }
    return json.dumps(data, indent=2) + "\n"


def proposal(found: Comparison, image: str, page: str) -> str:
    """Return the text of a pull request with a new lock; ``page`` is that of the run that published the image."""
    lines = [line(change) for change in found.changes]
    more = [f"and {len(lines) - MOST} more"] if len(lines) > MOST else []
    counted = f"{len(found.moved)} of {found.packages} packages are not as the lock has them"
    parts = [
        f"What {code(image)} was made of. It was built and proved by [this run]({page}).\n",
        f"{counted}. Once this is merged, each build takes these versions, until `roslab lock` or the next proposal.\n",
        folded("What is new", block("\n".join((*lines[:MOST], *more)))),
        "GitHub starts no workflow for a pull request of a workflow: close and open it again to have it checked.\n",
    ]
    return "\n".join(parts)
