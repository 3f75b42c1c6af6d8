"""The programs and images that a build itself runs, each at one version: what floats is another program tomorrow."""

from __future__ import annotations

from typing import Literal

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Pin:
    """One of them."""

    image: str
    """``""`` for a program that is no image."""
    version: str
    digest: str = ""

    @property
    def reference(self) -> str:
        """Return the image to pull: its tag, for a person, and its digest where that is known, for docker."""
        return f"{self.image}:{self.version}" + (f"@{self.digest}" if self.digest else "")


def pin(name: Literal["buildx", "buildkit", "binfmt", "scanner"]) -> Pin:
    """Return the pin of a part of the builder."""
    row = next(row for row in rows("pins") if row["name"] == name)
    return record(Pin, row)
