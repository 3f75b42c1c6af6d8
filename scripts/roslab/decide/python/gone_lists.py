"""A list of packages that the page at the root installs, of a tree that has none: nothing else says what it held."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_LIST = pattern(r"(?:\./)?requirements?(?:[-_]\w+)?\.txt")


def gone_lists(evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for the first such list; one of what a page clones, or that a submodule may have, is none."""
    if evidence.requirements or any(git.kind != "link" for git in evidence.sources):
        return
    for asked in evidence.prose_pip:
        of_page = asked.file.endswith((".md", ".rst")) and "/" not in asked.file
        if of_page and asked.role == "file" and _LIST.fullmatch(asked.written):
            does = "what the manifests and the code name is installed; name the rest under `pip` in roslab.yaml"
            yield warn(f"the page installs {asked.written}, which the tree does not have: {does}", asked)
            return
