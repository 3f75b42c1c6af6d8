"""CUDA versions of pages that are above that of the torch which a lock at the root has, and so need a newer driver."""

from __future__ import annotations

from roslab.decide.cuda.local import cuda_of
from roslab.decide.python.pins import DEVELOPMENT
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import framework
from roslab.values.pattern import pattern
from roslab.values.version import Version

_NIGHTLY = pattern(r"/whl/(?:nightly|test)/")


def cuda_of_lock(evidence: Evidence) -> str | None:
    """Return the CUDA of the torch of pip's own index that a lock has, ``None`` where pip may take another build.

    A page's index of nightly builds has no release, so that pip takes none of it beside a lock.
    """
    found = {each.requirement.release for each in evidence.locked if each.requirement.key == "torch"}
    release = next(iter(found)) if len(found) == 1 else None
    row = framework("torch", release) if release and "+" not in release else None
    options = [option for file in evidence.requirements for option in file.options]
    said = (asked for asked in evidence.prose_pip if asked.role == "option" and not DEVELOPMENT.search(asked.file))
    options += [asked.written for asked in said]
    if row is None or any(cuda_of(option) and not _NIGHTLY.search(option) for option in options):
        return None
    return row.cuda[0]


def above(cuda: str, locked: str | None) -> bool:
    """Tell whether a CUDA is of a later major version than the lock's: the driver of that one does not run it.

    Within one, older drivers do: https://docs.nvidia.com/deploy/cuda-compatibility/minor-version-compatibility.html.
    """
    return locked is not None and Version(cuda).major > Version(locked).major
