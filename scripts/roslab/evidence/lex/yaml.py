"""YAML of strangers, loaded with bounds: PyYAML's C loader recurses without a limit of its own."""

from __future__ import annotations

import re
from typing import Any

MAX_DEPTH = 100
_BRACKETS = re.compile(r"[\[\]{}]")
_DEEP = re.compile(rf"^(?:[ \t]*(?:- )){{{MAX_DEPTH},}}|^ {{1000,}}\S", re.MULTILINE)


def load(text: str) -> Any:
    """Return the first document, ``None`` where it is no YAML or nested deeper than any person writes."""
    depth = deepest = 0
    for match in _BRACKETS.finditer(text):
        depth = max(0, depth + (1 if match[0] in "[{" else -1))
        deepest = max(deepest, depth)
    if deepest > MAX_DEPTH or _DEEP.search(text):
        return None
    import yaml  # noqa: PLC0415 - 20 ms that most repositories never need

    try:
        return next(yaml.load_all(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)), None)
    except (yaml.YAMLError, ValueError, RecursionError, TypeError, KeyError, AttributeError, OverflowError):
        return None
