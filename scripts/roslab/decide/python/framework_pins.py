"""The framework's version where a manifest leaves it free and an install line does not."""

from __future__ import annotations

import re
from collections.abc import Iterable

from packaging.requirements import InvalidRequirement, Requirement

from roslab.decide.decision import Reason
from roslab.decide.python.pins import Pin, pins
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import framework, version

_BUILD = re.compile(r"^([A-Za-z][\w.-]*)-cu(\d{2,3})(?![\w.-])")
_LEADING = {"torch": "torch", "tensorflow": "tensorflow", "jax": "jax"}
_BESIDE = {"torch": ("torchvision", "torchaudio"), "jax": ("jaxlib",), "tensorflow": ()}
"""Released together with it: their pins count where they stand in the same file."""


def framework_pins(
    evidence: Evidence, lines: Iterable[str], cuda: str | None
) -> tuple[tuple[str, ...], tuple[Reason, ...]]:
    """Return constraints for frameworks that ``lines`` leave free, from install lines that fit the image's CUDA.

    The newest framework of today is not what the code, its compiled parts and the image's CUDA are for.
    """
    free = {r.name.lower(): r for line in lines if (r := _free(line))}
    said = [pin for pin in pins(evidence) if pin.trust == 1 and pin.release]
    found: dict[str, Reason] = {}
    for name, table in _LEADING.items():
        leading = next((p for p in said if name == p.name and name in free and _fits(p, free[name], table, cuda)), None)
        if leading is None:
            continue
        for pin in (leading, *(p for p in said if p.name in _BESIDE[name] and p.name in free)):
            if pin.dependency.file == leading.dependency.file:
                why = "an install line pins what the manifest leaves free"
                found.setdefault(f"{pin.name}=={pin.release}", _reason(pin, why))
    return tuple(found), tuple(found.values())


def one_build(lines: Iterable[str], cuda: str | None) -> list[str]:
    """Return the lines with one build of each package: ``spconv-cu102`` and ``spconv-cu116`` hold the same module."""
    kept = list(lines)
    builds: dict[str, list[tuple[str, str]]] = {}
    for line in kept:
        if match := _BUILD.match(line):
            builds.setdefault(match[1].lower(), []).append((match[2], line))
    for same in builds.values():
        fitting = [line for digits, line in same if digits == (cuda or "").replace(".", "")] or [same[0][1]]
        kept = [line for line in kept if line in fitting[:1] or line not in {other for _, other in same}]
    return kept


def _free(line: str) -> Requirement | None:
    try:
        requirement = Requirement(line)
    except InvalidRequirement:
        return None
    limits = {"==", "===", "<", "<=", "~="}
    limited = requirement.url or any(specifier.operator in limits for specifier in requirement.specifier)
    return None if limited else requirement


def _fits(pin: Pin, manifest: Requirement, table: str, cuda: str | None) -> bool:
    release = pin.release or ""
    if cuda is None or not manifest.specifier.contains(release.partition("+")[0], prereleases=True):
        return False
    if local := re.search(r"\+cu(\d{2,3})$", release):
        return f"{local[1][:-1]}.{local[1][-1]}" == cuda
    row = framework(table, release)
    return row is not None and any(version(each) == version(cuda)[:2] for each in row.cuda)


def _reason(pin: Pin, why: str) -> Reason:
    answer = f"{pin.name}=={pin.release}"
    place = pin.dependency
    return Reason(question="dependencies", answer=answer, reason=why, file=place.file, line=place.line, weight=30)
