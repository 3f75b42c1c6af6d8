"""The options with which the page at the root has the repository itself configured by CMake."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.ros.source_names import plain
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_OWN = pattern(r"-D(?!CMAKE_)[A-Za-z_]\w*?(?<!_DIR)(?<!_ROOT)(?<!_PATH)(?<!_PREFIX)(?::[A-Z]+)?=[\w.+-]+")
"""An option of the project's own; CMake's are about the author's machine, and paths too."""


def own_options(evidence: Evidence, config: Config, folder_name: str) -> tuple[str, ...]:
    """Return the options of the first ``cmake`` that a page at the root runs for the repository, not for a library.

    ``folder_name`` is the repository's name, into whose folder the page may go.
    """
    names = {plain(folder_name), *(plain(p.name) for p in evidence.cmake if p.top_level and p.name)}
    for said in evidence.mentions:
        if said.topic == "compiled" and said.source == "readme" and "/" not in said.file and not config.compatible:
            last = said.value.rpartition("/")[2]
            if said.value == "." or plain(last) in names:
                return tuple(word for word in said.text.split() if _OWN.fullmatch(word))
    return ()
