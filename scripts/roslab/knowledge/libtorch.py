"""The archives of libtorch, the C++ library of PyTorch, that are compiled as Ubuntu's own libraries are."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.frameworks import framework
from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def oldest() -> Version:
    """Return the first release whose archive links with libraries of Ubuntu: earlier ones have the ABI before C++11."""
    return Version(rows("libtorch")[0]["first"])


def libtorch_archive(release: str, cuda: str | None) -> str:
    """Return the address for a release, that for a CUDA (``11.8``) if the release has one, else that for the CPU.

    Raises ``ValueError`` for a release before ``oldest``.
    """
    fitting = [row for row in rows("libtorch") if Version(row["first"]) <= Version(release)]
    if not fitting:
        raise ValueError(f"no archive of libtorch {release}")
    row, series = fitting[-1], framework("torch", release)
    if cuda and row["cuda"] and series and cuda in series.cuda:
        return row["cuda"].format(release=release, cuda=f"cu{cuda.replace('.', '')}")
    return row["cpu"].format(release=release)
