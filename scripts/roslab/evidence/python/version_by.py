"""Which tables of a pyproject.toml say that its version comes from git."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

SCM = "setuptools-scm"


def version_by(data: dict[str, Any]) -> Iterator[str]:
    """Yield the tools that a pyproject.toml has give its version, as ``version_tools`` calls them.

    https://scikit-build-core.readthedocs.io/en/latest/configuration/dynamic.html,
    https://setuptools-scm.readthedocs.io/en/latest/usage/, https://github.com/ofek/hatch-vcs,
    https://backend.pdm-project.org/metadata/#dynamic-project-version,
    https://github.com/mtkennerly/poetry-dynamic-versioning, all read 2026-11-27
    """
    if "version" in _table(data, "project"):
        return
    provider = _table(data, "tool", "scikit-build", "metadata", "version").get("provider")
    if isinstance(provider, str) and provider.endswith("setuptools_scm"):
        yield SCM
    tools = _table(data, "tool")
    if isinstance(tools.get("setuptools_scm"), dict):
        yield SCM
    if _table(data, "tool", "hatch", "version").get("source") == "vcs":
        yield "hatch-vcs"
    if _table(data, "tool", "pdm", "version").get("source") == "scm":
        yield "tool.pdm.version"
    if _table(data, "tool", "poetry-dynamic-versioning").get("enable") is True:
        yield "poetry-dynamic-versioning"


def _table(data: Any, *keys: str) -> dict[str, Any]:
    for key in keys:
        data = data.get(key) if isinstance(data, dict) else None
    return data if isinstance(data, dict) else {}
