"""Logs of failed builds that tests write, and what repairs the build of a small tree."""

from __future__ import annotations

import io
from collections.abc import Mapping
from pathlib import Path

from roslab.cli.repairing import given
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.repair.change import Repair
from roslab.repair.repair import repair
from trees import tree_of


def log(command: str, *lines: str) -> str:
    """Return BuildKit's log of a step that failed, with what it printed."""
    said = "".join(f"#6 1.2 {line}\n" for line in lines)
    return f'#6 [3/4] RUN {command}\n{said}#6 ERROR: process "/bin/sh -c {command}" did not complete: exit code: 1\n'


def repaired(folder: Path, text: str, files: Mapping[str, str] | None = None) -> Repair:
    """Return what repairs the build of a folder, in which ``files`` are written first."""
    tree_of(folder, dict(files or {}))
    return repair(explain(io.BytesIO(text.encode())), given(plan_repository(folder)))
