"""Pins to what an author, a vendor or a cluster built: no index has it, and a release of that number is installed."""

from __future__ import annotations

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.frameworks import family_of
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

_LEADING = "torch"
_ALPHA = pattern(r"(\d+\.\d+)(?:\.\d+)*a\d+(?:\+\S+)?")
"""What PyTorch's own projects are called that were compiled from source; their releases have no alphas."""
_LOCAL = pattern(r"(\d+(?:\.\d+)+(?:\.?post\d+)?)\+(\S+)")
"""https://packaging.python.org/en/latest/specifications/version-specifiers/#local-version-identifiers: indexes for
everybody take none."""
_OF_AN_INDEX = pattern(r"(?:cu|pt|torch|cpu|rocm|xpu|cxx|nightly|g[0-9a-f]{6,}$)")
"""Builds for a CUDA, a torch or a processor, which indexes of their own have; and a commit of another number."""


def built(asked: Requirement) -> Requirement | None:
    """Return the release in place of such a build, ``None`` for all others.

    What is released with torch is named alone, for each of its releases asks pip for one of torch, which is pinned.
    """
    release = asked.release
    if release is None or asked.url or not asked.name:
        return None
    if asked.key in family_of(_LEADING) and (alpha := _ALPHA.fullmatch(release)):
        return _instead(asked, f"=={alpha[1]}.*" if asked.key == _LEADING else "")
    local = _LOCAL.fullmatch(release)
    return _instead(asked, f"=={local[1]}") if local and not _OF_AN_INDEX.match(local[2]) else None


def _instead(asked: Requirement, version: str) -> Requirement:
    extras = f"[{','.join(asked.extras)}]" if asked.extras else ""
    taken = stated(f"{asked.name}{extras}{version}", asked.origin, asked.file, asked.line)
    return replace(taken, marker=asked.marker, role=asked.role, group=asked.group)


def told(asked: Requirement, taken: Requirement) -> Warning_:
    """Return the warning about one of them."""
    which = taken.written if taken.limited else f"the {taken.name} that goes with torch"
    return warn(f"no index has {asked.written}, which was built elsewhere: {which} is installed", asked)
