"""Of several ways in which a page installs torch, for one CUDA each, the one that is taken."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.decide.cuda.local import cuda_of
from roslab.decide.python.guesses import FRAMEWORKS
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import family_of, framework, imports
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version

_TORCH = "torch"
_CPU = "cpuonly"
"""The package of conda that chooses the builds without CUDA."""
_NO_CUDA = pattern(r"/whl/(?:nightly/)?(?:cpu|rocm[\d.]*)(?:/|$)|\+(?:cpu|rocm[\d.]*)$")
_ALL_BUILDS = "/whl/torch_stable.html"
"""The page with the builds for all CUDAs and for AMD's GPUs, of which pip takes the last in the alphabet."""
_NAMES_TORCH = pattern(r"\b(?:torch-?|pt_?)(\d+\.\d+(?:\.\d+)?)\b")
"""A page of wheels that are built for one torch: ``…/cu111/torch1.9.0/index.html``, ``…/torch-1.10.0+cu113.html``."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Way:
    """What one command asks for, of torch and what belongs to it."""

    asked: tuple[Requirement, ...]
    options: tuple[Requirement, ...]
    cuda: str | None
    """The CUDA that it names."""
    pinned: bool
    computes: bool
    """It is for a GPU, as far as it says."""


def without_lists(evidence: Evidence, kind: Kind) -> Evidence:
    """Return the evidence without what pages list, for packages of ROS: their manifests say what they need.

    Frameworks that code imports stay where no manifest asks for them: rosdep has no key for most of them, and nothing
    else asks for one that only code beside the nodes imports.
    """
    if not (evidence.manifests and kind in {"ros1", "ros2"}):
        return evidence
    keys = {each.name for manifest in evidence.manifests for each in manifest.dependencies}
    names = {asked.key for asked in evidence.listed} & FRAMEWORKS
    names &= _imported(evidence) if names else set()
    names = {name for name in names if not any(name in key for key in keys)}
    return replace(evidence, listed=tuple(asked for asked in evidence.listed if asked.key in names))


def _imported(evidence: Evidence) -> set[str | None]:
    """Return the packages of the modules that the code itself always imports."""
    used = {each.name for each in evidence.code if each.strength == "used" and not places.aside(each.file)}
    return {imports()[name][0] for name in used if name in imports()}


def named_by_wheels(evidence: Evidence) -> Evidence:
    """Return the evidence with the torch of a page of wheels that something is installed from, if nothing pins one."""
    everywhere = [*evidence.prose_pip, *evidence.listed]
    everywhere += [asked for file in evidence.requirements for asked in file.requirements]
    everywhere += [asked for project in evidence.python for asked in project.requirements]
    pinned = any(asked.key == _TORCH and (asked.release or asked.url) for asked in everywhere)
    pinned = pinned or any(p.name == "pytorch" and p.release for each in evidence.conda for p in each.packages)
    for asked in evidence.prose_pip if not pinned else ():
        match = _NAMES_TORCH.search(asked.written) if asked.role == "option" else None
        row = framework(_TORCH, match[1]) if match else None
        if match and row:
            cuda = cuda_of(asked.written)
            local = f"+cu{cuda.replace('.', '')}" if cuda in row.cuda and cuda else ""
            torch = stated(f"torch=={match[1]}{local}", "prose", asked.file, asked.line)
            return replace(evidence, prose_pip=(*evidence.prose_pip, torch))
    return evidence


def one_way(evidence: Evidence, cuda: str | None) -> Evidence:
    """Return the evidence without the other ways: the one that fits ``cuda`` stays, a pinned one before others.

    Indexes without wheels for CUDA go as well: pip would take their builds, whose names come last.
    """
    if cuda is None:
        return evidence
    dropped: set[Requirement] = set()
    for page in dict.fromkeys(asked.file for asked in evidence.prose_pip if asked.key == _TORCH):
        ways = list(_ways(evidence, page))
        best = min(ways, key=lambda way: (not way.computes, _misfit(way, cuda), not way.pinned))
        dropped |= {each for way in ways if way is not best for each in (*way.asked, *way.options)}
    kept = [asked for asked in evidence.prose_pip if asked not in dropped]
    builds = any(asked.key in _family() and "+" in (asked.release or "") for asked in kept)
    found = tuple(asked for asked in kept if asked.role != "option" or _of_use(asked.written, builds=builds))
    return replace(evidence, prose_pip=found) if len(found) < len(evidence.prose_pip) else evidence


def _family() -> frozenset[str]:
    return family_of(_TORCH) | {_CPU}


def _of_use(option: str, *, builds: bool) -> bool:
    return not _NO_CUDA.search(option) and (builds or not option.endswith(_ALL_BUILDS))


def _ways(evidence: Evidence, page: str) -> Iterator[Way]:
    """Yield each way of one page; what belongs to torch stands in its command, on its line or on one of the next."""
    asked = [each for each in evidence.prose_pip if each.file == page]
    family = [each for each in asked if each.key in _family()]
    starts = sorted({each.line for each in family if each.key == _TORCH})
    for start, following in zip(starts, [*starts[1:], None], strict=True):
        own = [each for each in family if start == max((s for s in starts if s <= each.line), default=starts[0])]
        last = max(each.line for each in own) + 1
        last = last if following is None else min(last, following - 1)
        options = [each for each in asked if each.role == "option" and start <= each.line <= last]
        torch = next(each for each in own if each.key == _TORCH)
        said = (m.value for m in evidence.mentions if (m.topic, m.file, m.line) == ("cuda", page, start))
        local = (cuda_of(text) for text in (torch.release or "", torch.url, *(each.written for each in options)))
        named = next(said, None) or next(filter(None, local), None)
        texts = (torch.release or "", *(each.written for each in options))
        without = any(each.key == _CPU for each in own) or any(map(_NO_CUDA.search, texts))
        yield Way(
            asked=tuple(own),
            options=tuple(options),
            cuda=named or _default(torch),
            pinned=bool(torch.release),
            computes=bool(named) or not without,
        )


def _default(torch: Requirement) -> str | None:
    """Return the CUDA of the wheel that the index has for a release."""
    row = framework(_TORCH, torch.release) if torch.release else None
    return row.cuda[0] if row and torch.release and not Version(torch.release).local else None


def _misfit(way: Way, cuda: str) -> int:
    return 0 if way.cuda == cuda else 1 if way.cuda is None else 2
