"""What somebody wrote under a key with one value: a repair says what it is to be exchanged for, and never does it."""

from __future__ import annotations

from roslab.config.addition import SINGLE, value_of
from roslab.repair.change import Change, Given
from roslab.values.dataclass import replace
from roslab.values.origin import Place


def yielding(change: Change, given: Given) -> Change:
    """Return a change; one that would exchange such a value is no longer certain, and says who has to do it.

    A value of a list that is gone (a release, a package that was renamed) is another matter: nothing can take it.
    """
    if change.key not in SINGLE or change.key in given.added:
        return change
    old = value_of(given.config, change.key)
    adds = change.value.endswith(f":{old}") or change.value.startswith(f"{old} ")  # to a path, or to flags
    if not old or old == change.value or adds:
        return change
    written = given.config.origin(change.key) or Place(file=given.config.file or "roslab.yaml")
    return replace(change, certain=False, instead=old, written=written)
