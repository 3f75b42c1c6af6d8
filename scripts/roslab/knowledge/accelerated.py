"""Python packages that compute on CUDA."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.specifier import specifiers


@cache
def accelerated() -> frozenset[str]:
    """Return their names, as pip, conda and ``import`` spell them."""
    return frozenset(row["name"] for row in rows("accelerated"))


@cache
def by_extra() -> frozenset[str]:
    """Return those of them that compute on the CPU unless their wheels for CUDA are asked for: ``jax[cuda12]``."""
    return frozenset(row["name"] for row in rows("accelerated") if row["by_extra"])


@cache
def computed_by() -> dict[str, str]:
    """Return what computes only by another package of the table, and which: ``keras`` by ``tensorflow``."""
    return {row["name"]: row["by"] for row in rows("accelerated") if row["by"]}


def without_gpu(name: str, release: str) -> bool:
    """Tell whether pip's wheel of a release computes on the CPU alone: another package had the one for GPUs."""
    ranges = next((row["without_gpu"] for row in rows("accelerated") if row["name"] == name), "")
    allowed = (specifiers(text) for text in ranges.split())
    return bool(release) and any(each and each.contains(release, prereleases=True) for each in allowed)


def plugin_of_jax(name: str) -> str:
    """Return what a wheel for CUDA that JAX is frozen with is called after: ``cuda12`` of ``jax-cuda12-plugin``."""
    return name.removeprefix("jax-") if name.startswith("jax-cuda") else ""


def cuda_of_jax(name: str, extras: Iterable[str]) -> str | None:
    """Return the CUDA that the first of JAX's ``extras`` names (``cuda12``, ``cuda12_pip``), or that of its plugin."""
    asked = extras if name == "jax" else (plugin_of_jax(name),)
    known = {row["extra"]: row["cuda"] for row in rows("jax_extras")}
    return next((cuda for extra in asked for name, cuda in known.items() if extra.startswith(name)), None)
