"""Pages of wheels whose builds are not for the torch of the image: wheels of several builds have one file name."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from roslab.decide.cuda.local import cuda_of
from roslab.decide.decision import Choice, Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.frameworks import framework
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.version import minor_of

_FAMILY = frozenset({"torch", "torchvision", "torchaudio"})
_ALL_BUILDS = "download.pytorch.org/whl/torch_stable.html"
_PAGE = pattern(r"--find-links \S*?(?:/cu\d{2,3}/torch(\d+\.\d+)|/torch-(\d+\.\d+)[\d.]*\+cu\d{2,3})")
"""A page for one torch and one CUDA, as those of mmcv and of PyTorch Geometric are named."""
_OWN = pattern(r"download\.pytorch\.org/whl/cu\d+")


@dataclass(frozen=True, kw_only=True, slots=True)
class _Torch:
    """A torch by its minor release, and the CUDA of its wheel."""

    minor: str
    cuda: str


def fitting_pages(options: Iterable[str], asked: Iterable[Requirement]) -> Choice[tuple[str, ...]]:
    """Return pip's options, each once, without pages that are for another torch than the one ``asked`` for.

    Where no build of torch is asked for, without the page of all of them, too, of which pip takes the highest:
    ``+rocm`` and ``+cu92`` are above ``+cu110``, and all above the one of pip's index.
    https://packaging.python.org/en/latest/specifications/version-specifiers/#local-version-identifiers, 2026-11-26
    """
    options = tuple(dict.fromkeys(options))
    family = [each for each in asked if each.key in _FAMILY]
    builds = not family or any(each.url or "+" in (each.release or "") for each in family)
    torch = _torch(options, [each for each in family if each.key == "torch"])
    kept, warnings = list[str](), list[Warning_]()
    for option in options:
        match, cuda = _PAGE.match(option), cuda_of(option)
        if match and torch and (match[1] or match[2], cuda) != (torch.minor, torch.cuda):
            page, built = option.partition(" ")[2], f"torch {match[1] or match[2]} and CUDA {cuda}"
            image = f"torch {torch.minor} for CUDA {torch.cuda}"
            warnings.append(warn(f"{page} is left out: its wheels are for {built}, the image has {image}"))
        elif builds or not option.endswith(_ALL_BUILDS):
            kept.append(option)
    return Choice(answer=tuple(kept), warnings=tuple(warnings))


def _torch(options: Sequence[str], asked: Sequence[Requirement]) -> _Torch | None:
    """Return the torch that pip takes, ``None`` where nothing pins it or its build is not known."""
    pinned = next((each for each in asked if each.release and not each.url), None)
    release = (pinned.release or "") if pinned else ""
    row = framework("torch", release) if release else None
    own = next((cuda_of(option) for option in options if _OWN.search(option)), None)
    cuda = cuda_of(release) or own or (row.cuda[0] if row and row.cuda and "+" not in release else None)
    minor = minor_of(release)
    return _Torch(minor=minor, cuda=cuda) if minor and cuda else None
