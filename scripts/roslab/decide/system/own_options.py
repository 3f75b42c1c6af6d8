"""The options and the compiler with which the page at the root has the repository itself configured by CMake."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.ros.source_names import plain
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_OWN = pattern(r"-D(?!CMAKE_)[A-Za-z_]\w*?(?<!_DIR)(?<!_ROOT)(?<!_PATH)(?<!_PREFIX)(?::[A-Z]+)?=[\w.+-]+")
"""An option of the project's own; CMake's are about the author's machine, and paths too."""


_COMPILER = pattern(r"-DCMAKE_(C|CXX)_COMPILER(?::[A-Z]+)?=(?:/usr/bin/)?((?:gcc|g\+\+|clang|clang\+\+)-\d+(?:\.\d+)?)")
_VARIABLES = {"C": "CC", "CXX": "CXX"}


def own_options(evidence: Evidence, config: Config, folder_name: str) -> tuple[str, ...]:
    """Return the options of the first ``cmake`` that a page at the root runs for the repository, not for a library.

    ``folder_name`` is the repository's name, into whose folder the page may go.
    """
    return tuple(word for word in _said(evidence, config, folder_name) if _OWN.fullmatch(word))


def own_compilers(evidence: Evidence, config: Config, folder_name: str) -> tuple[tuple[str, str], ...]:
    """Return the compilers of a version that the same ``cmake`` names, each with its variable: ``CXX``, ``g++-10``."""
    found = (_COMPILER.fullmatch(word) for word in _said(evidence, config, folder_name))
    return tuple((_VARIABLES[match[1]], match[2]) for match in found if match)


def _said(evidence: Evidence, config: Config, folder_name: str) -> list[str]:
    names = {plain(folder_name), *(plain(p.name) for p in evidence.cmake if p.top_level and p.name)}
    for said in evidence.mentions:
        of_page = said.topic == "compiled" and said.source == "readme" and "/" not in said.file
        own = said.value == "." or plain(said.value.rpartition("/")[2]) in names
        if of_page and own and not config.compatible:
            return said.text.split()
    return []
