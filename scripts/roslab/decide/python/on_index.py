"""The package of pip's index for a module that the table of imports has not: a link's, or one of the same name."""

from __future__ import annotations

from functools import lru_cache

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.guesses import ros_modules
from roslab.knowledge.on_index import named_like
from roslab.knowledge.released import ever_released
from roslab.values.name import bare_name, canonicalize_name

_SHORTEST = 4
"""Fewest letters of a module that stand in a package's name by more than chance."""


def on_index(evidence: Evidence, used: Dependency) -> str | None:
    """Return the package to which the tree links for this module, else a known one of its name, ``None`` for none.

    A link is one for the module that its package is called like, or that is imported on its line or the next one:
    ``# the sensor: https://…/project/mpu6050-raspberrypi/``. A module of ROS is none of the index.
    """
    if used.name in ros_modules() or ever_released(used.name):
        return None
    links = _links(evidence)
    found = next((each.value for each in links if _at(used, each)), None)
    found = found or next((each.value for each in links if _called_like(used.name, each.value)), None)
    return found or named_like(used.name)


@lru_cache(maxsize=2)
def _links(evidence: Evidence) -> tuple[Mention, ...]:
    """Return the links to the index, found once for all the modules that the code imports."""
    return tuple(each for each in evidence.mentions if each.topic == "index_link")


def _at(used: Dependency, link: Mention) -> bool:
    above = link.line == used.line - 1 and link.text.lstrip().startswith("#")
    return link.file == used.file and (above or link.line == used.line)


def _called_like(module: str, package: str) -> bool:
    """Tell whether a package is called like a module, or like it with one more word: ``acme-arm-driver``."""
    name, other = bare_name(module), bare_name(package)
    more = with_one_word_more(module, package)
    return name == other or more or (len(name) >= _SHORTEST and other.endswith(name))


def with_one_word_more(module: str, package: str) -> bool:
    """Tell whether a package has the words of a module's name and one before or behind them: ``acme-api``."""
    words, others = canonicalize_name(module).split("-"), canonicalize_name(package).split("-")
    more = len(others) == len(words) + 1 and words in (others[:-1], others[1:])
    return more and len(bare_name(module)) >= _SHORTEST
