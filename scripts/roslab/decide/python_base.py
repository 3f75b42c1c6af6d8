"""The base image of plain Python and CUDA repositories."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.decision import Reason


def base_for(
    kind: Kind, cuda: str | None, cudnn: str | None, ubuntu: str | None, python_version: str | None
) -> tuple[str, str | None, tuple[Reason, ...]]:
    """Return the image, its Ubuntu codename (``None`` on Debian) and why."""
    del cudnn, python_version
    if kind == "cuda" and cuda:
        return f"nvidia/cuda:{cuda}.0-devel-ubuntu22.04", "jammy", ()
    return "ubuntu:22.04", ubuntu or "jammy", ()
