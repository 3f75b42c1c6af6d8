"""What Python's packages are asked for by more than the tree itself: clones, fetched files, wheels, extension code."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.python.alternatives import named_by_wheels, without_lists
from roslab.decide.python.cloned import with_cloned
from roslab.decide.python.extension_code import with_bounds
from roslab.decide.python.fetched import with_fetched
from roslab.decide.python.imported_submodules import with_imported
from roslab.decide.python.library_modules import with_library_modules
from roslab.decide.python.other_indexes import with_other_indexes
from roslab.decide.python.torch_indexes import without_unlocked
from roslab.evidence.facts import Evidence


def with_what_is_brought(evidence: Evidence, kind: Kind, folder_name: str) -> Evidence:
    """Return the evidence with what clones and fetched files ask for, and the limits that follow from it."""
    asked = with_library_modules(with_imported(with_fetched(evidence), kind))
    whole = without_lists(with_cloned(asked, kind, folder_name), kind)
    return with_other_indexes(with_bounds(named_by_wheels(without_unlocked(whole)), kind), kind)
