"""Packages of apt that a vendor's own source alone has: the build goes on where that has none for the image."""

from __future__ import annotations

from collections.abc import Collection

from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.decide.system.packages import SystemPackages
from roslab.evidence.apt_source import host_of
from roslab.knowledge.apt_sources import added_sources
from roslab.values.dataclass import replace


def may_lack(system: Choice[SystemPackages], base_image: str, own: Collection[str]) -> Choice[SystemPackages]:
    """Return the packages with those that may fail which only a vendor's images have; each is told.

    ``own``: those of roslab.yaml, which have to install.
    """
    known = [each for each in added_sources() if each.base.pattern and not each.base.fullmatch(base_image)]
    found = {
        name: host_of(each.url)
        for name in system.answer.apt
        for each in known
        if name not in own and each.packages.fullmatch(name)
    }
    if not found:
        return system
    places = {reason.answer: reason for reason in reversed(system.reasons) if reason.file}
    told = tuple(
        warn(
            f"{name} is only in its vendor's own source ({host}), in its newest release; "
            "if that does not install, what links it is not built",
            places.get(name),
        )
        for name, host in found.items()
    )
    answer = replace(
        system.answer,
        apt=tuple(name for name in system.answer.apt if name not in found),
        apt_guessed=tuple(dict.fromkeys((*system.answer.apt_guessed, *found))),
    )
    return replace(system, answer=answer, warnings=(*system.warnings, *told))
