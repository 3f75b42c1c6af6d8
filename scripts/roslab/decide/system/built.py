"""What is known of a build where its warnings are written."""

from __future__ import annotations

from collections.abc import Collection

from roslab.config.model import BuildTool, Kind
from roslab.decide.system.names import Target
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Built:
    """The image, its build tool, and what is there."""

    target: Target
    names: Collection[str]
    """Those of all that is installed, built or cloned, in one spelling; a similar one may bring what is asked for."""
    build_tool: BuildTool
    kind: Kind
    out: Collection[str]
    """Packages that are not built."""
