"""What a repository of a kind builds, of all that its tree says."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.python.brought import with_what_is_brought
from roslab.decide.ros.not_built import of_what_is_built
from roslab.decide.system.cmeel import with_wheels
from roslab.decide.system.compiled_signs import with_compiled_signs
from roslab.evidence.facts import Evidence


def of_kind(evidence: Evidence, kind: Kind, folder_name: str) -> Evidence:
    """Return the evidence of what a repository of a kind builds, with the signs of what it brings and compiles."""
    found = with_wheels(of_what_is_built(evidence, kind), kind, folder_name)
    brought = with_what_is_brought(found, kind, folder_name)
    return with_compiled_signs(brought, kind)
