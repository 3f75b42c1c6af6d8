"""Packages that CI takes out of its workspace before it builds: industrial_ci's ``TARGET_WORKSPACE``, marked folders.

https://github.com/ros-industrial/industrial_ci/blob/master/doc/index.rst, "Workspace definition", read on 2026-11-26
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.yaml import Scalar
from roslab.evidence.prose.ci_conditions import condition_of
from roslab.values.pattern import pattern

NAME = "target_workspace"
MARKERS = ("/COLCON_IGNORE", "/CATKIN_IGNORE", "/AMENT_IGNORE")
"""Files that make a build tool pass over the folder in which they lie."""
_ASSIGNED = pattern(r"\bTARGET_WORKSPACE=(?:\"([^\"\n]*)\"|'([^'\n]*)'|(\S+))")
_REMOVED = pattern(r"(?<!\S)-(\w[\w./-]*)")


def taken_out(values: Iterable[Scalar], file: str) -> Iterator[Mention]:
    """Yield the folders that every target workspace of a CI file is without; one that another builds can be built."""
    found: list[tuple[Scalar, list[str]]] = []
    for value in values:
        whole = (value.text,) if value.key.lower() == NAME else ()
        assigned = ("".join(group or "" for group in match.groups()) for match in _ASSIGNED.finditer(value.text))
        found += [(value, _REMOVED.findall(text)) for text in (*whole, *assigned)]
    for value, paths in found[:1]:
        for path in paths:
            if all(path in others for _, others in found):
                text = value.text.strip()[:200]
                yield Mention(topic="skipped", value=path, source="ci", file=file, line=value.line, text=text)


def marked(words: tuple[str, ...], folder: str) -> Iterator[str]:
    """Yield the folders in which ``touch`` puts a marker; ``folder`` is where the text is by then."""
    for word in words[1:]:
        path = f"{folder}/{word}"
        if path.endswith(MARKERS):
            yield path.rpartition("/")[0].strip("/")


def conditional(mention: Mention, text: str) -> bool:
    """Tell whether a step of a CI file that makes a marker has a condition: other runs build the package."""
    return mention.topic == "skipped" and condition_of(text, mention.line) is not None
