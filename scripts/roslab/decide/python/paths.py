"""The folders of the tree that Python looks into, as the pages of the author set them."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.evidence.facts import Evidence


def python_path(evidence: Evidence, config: Config, kind: Kind) -> tuple[str, ...]:
    """Return the folders that pages put on PYTHONPATH, each once; ROS and roslab.yaml have their own."""
    if config.compatible or kind not in {"python", "cuda"} or "PYTHONPATH" in dict(config.env):
        return ()
    return tuple(dict.fromkeys(m.value for m in evidence.mentions if m.topic == "python_path"))
