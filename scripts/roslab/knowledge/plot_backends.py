"""What matplotlib draws its windows with, by the name that code gives it: ``matplotlib.use("GTK3Agg")``."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from roslab.knowledge.table import rows


class PlotBackend(NamedTuple):
    """What a backend imports, and the packages of apt that this needs beside its own."""

    module: str
    apt: tuple[str, ...]


@cache
def plot_backends() -> dict[str, PlotBackend]:
    """Return the backends that need more than matplotlib and Tk, by their names in small letters, as it reads them."""
    return {row["backend"]: PlotBackend(row["module"], tuple(row["apt"].split())) for row in rows("plot_backends")}
