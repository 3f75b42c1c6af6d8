"""The lines on which a page has conda install torch: conda then takes the torch that was built for their CUDA."""

from __future__ import annotations

from roslab.evidence.facts import Evidence


def conda_torch(evidence: Evidence) -> frozenset[tuple[str, int]]:
    """Return the file and the line of each."""
    asked = (each for each in evidence.prose_pip if each.role == "conda" and each.key == "torch")
    return frozenset((each.file, each.line) for each in asked)
