"""The Makefile that is the whole project."""

from __future__ import annotations

from roslab.evidence.facts import Evidence
from roslab.evidence.makefile import Makefile


def builds_all(evidence: Evidence) -> Makefile | None:
    """Return the Makefile at the root that alone builds a tree; ``None`` where it has none, or others beside it.

    Nor where a page compiles the tree by a script.
    """
    said = (each for each in evidence.mentions if each.topic == "build_script" and each.source == "readme")
    by_script = any(each.files for each in said)
    made = evidence.makefiles[0] if len(evidence.makefiles) == 1 else None
    return made if made and not (by_script or made.folder or made.script or made.qt) else None
