"""The GPUs that the compiler of each CUDA knows, by their architectures."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.version import Version

NAME = "CUDA"
"""Of the toolkit among the libraries whose versions the code limits."""


@cache
def cuda_of_gpu(architecture: int) -> tuple[str | None, str | None]:
    """Return the first CUDA that compiles for an architecture (``86``), and the first that no longer does.

    ``None`` where the table has no such end; both for an architecture that it does not know at all.
    """
    known = [row for row in rows("cuda_gpus") if int(row["lowest"]) <= architecture <= int(row["highest"])]
    if not known:
        return None, None
    first, last = known[0]["cuda"], Version(known[-1]["cuda"])
    after = next((row["cuda"] for row in rows("cuda_gpus") if Version(row["cuda"]) > last), None)
    return first, after
