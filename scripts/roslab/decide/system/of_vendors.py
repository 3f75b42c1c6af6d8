"""Packages of apt that a vendor's own source alone has: the build goes on where that has none for the image."""

from __future__ import annotations

from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.decide.system.packages import SystemPackages
from roslab.knowledge.apt_sources import added_sources
from roslab.values.dataclass import replace


def may_lack(system: Choice[SystemPackages], base_image: str) -> Choice[SystemPackages]:
    """Return the packages with those that may fail which only a vendor's images have; each is told."""
    known = [each for each in added_sources() if each.base and not base_image.startswith(each.base)]
    found = [name for name in system.answer.apt if any(each.packages.fullmatch(name) for each in known)]
    if not found:
        return system
    why = "is in no archive of Ubuntu, but in its vendor's source, which is added where it has this Ubuntu, in the"
    told = tuple(
        warn(f"{name} {why} newest release: where none is found, what needs it is not built") for name in found
    )
    answer = replace(
        system.answer,
        apt=tuple(name for name in system.answer.apt if name not in found),
        apt_guessed=tuple(dict.fromkeys((*system.answer.apt_guessed, *found))),
    )
    return replace(system, answer=answer, warnings=(*system.warnings, *told))
