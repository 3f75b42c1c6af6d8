"""A compiler that is older than the code: its Ubuntu was chosen for the ROS that something names."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.code_limits import fits
from roslab.values.pattern import pattern
from roslab.values.version import Version

_GCC = "GCC"
_COMPILER = pattern(r"(?:g\+\+|gcc)-(\d+)")
"""Clang takes the headers of the GCC that is there."""


def decide_compiler(evidence: Evidence, config: Config, ubuntu: str | None, apt: Iterable[str]) -> Choice[None]:
    """Return a warning where the code needs a newer GCC than the Ubuntu has, and no package (``apt``) brings another.

    Not where roslab.yaml names a compiler: that may be newer.
    """
    asked = [each for each in evidence.limits if each.library == _GCC and each.at_least and not places.aside(each.file)]
    if not asked or ubuntu is None or config.compatible or {"CC", "CXX"} & {name for name, _ in config.env}:
        return Choice(answer=None)
    newest = max(asked, key=lambda each: Version(each.at_least or "0"))
    brought = (match[1] for name in apt if (match := _COMPILER.fullmatch(name)))
    if fits(_GCC, ubuntu, at_least=newest.at_least, below=None) or any(
        Version(each) >= Version(newest.at_least or "0") for each in brought
    ):
        return Choice(answer=None)
    message = (
        f"the code needs GCC {newest.at_least} or newer ({newest.what}), and {ubuntu} has an older one: what includes "
        "it does not compile; install a newer compiler by `custom` in roslab.yaml and name it there under `env` (CC, "
        "CXX), or set base.ubuntu or base.ros to one that has it"
    )
    return Choice(answer=None, warnings=(warn(message, newest),))
