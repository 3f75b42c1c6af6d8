"""A torch that was built with the CUDA of the image, where extensions are compiled against it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from roslab.decide.cuda.beside_torch import conda_torch
from roslab.decide.cuda.version import DEFAULT
from roslab.decide.decision import Choice, Reason
from roslab.decide.python.packages import Chosen
from roslab.decide.python.torch_indexes import ended_index
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.evidence.locked import Locked
from roslab.knowledge.frameworks import (
    Framework,
    framework,
    newest_framework,
    newest_on_cuda,
    oldest_on_cuda,
    with_numpy_2,
)
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version

ONE_PAGE_BEFORE = Version("1.11")
"""Before this release torch's wheels for a CUDA were listed on a page, not in an index of their own.

https://pytorch.org/get-started/previous-versions/, read 2026-08-22."""
ON_INDEX = Version("1.0")
"""The first release that pip's index has; PyTorch's pages have older ones: ``OLDEST_PAGE`` has all from 0.3.1 on."""
OLDEST_PAGE = "cu90"
_NEWEST = "the newest torch that was built with it"
Build = tuple[tuple[Requirement, ...], tuple[str, ...]]
"""Constraints, and pip's options."""


def beside_torch(evidence: Evidence) -> str | None:
    """Return the CUDA that a page asks conda for beside torch, ``None`` if none does.

    conda then takes the torch that was built for that CUDA, of no version the newest one.
    """
    torch = conda_torch(evidence)
    return next((m.value for m in evidence.mentions if m.topic == "cuda" and (m.file, m.line) in torch), None)


def decide_build(
    evidence: Evidence,
    chosen: Chosen,
    wheels: Sequence[Requirement],
    cuda: str | None,
    python: str | None,
    *,
    compiled: bool,
    aged: bool,
    bounds: Iterable[Requirement],
    locked: Iterable[Locked],
) -> Choice[Build]:
    """Return limits and pip's options for the torch among the ``wheels``; extensions may be ``compiled`` against it.

    ``locked`` are releases of a lock: where nothing is compiled its torch is taken. ``aged``: the code is of a torch
    that is older than every CUDA with an image.
    """
    day, below = evidence.pip_day, next((bound.below for bound in bounds if bound.key == "torch"), None)
    if compiled:
        return torch_build(wheels, cuda, python, day, oldest=aged, below=below)
    if on_page := beside_torch(evidence):
        return torch_build(wheels, on_page, python, day, "conda is asked for CUDA {cuda} beside it")
    if ended := ended_index(evidence, wheels, python, day, below):
        return torch_build(wheels, ended, python, day, "a page takes it from the index for CUDA {cuda}", below=below)
    said = (*chosen.options, *(option for file in chosen.files for option in file.options))
    known = any("download.pytorch.org" in option for option in said)
    of_image = cuda or DEFAULT  # a page that only lists torch names none
    return newer_wheel(() if known else _as_locked(wheels, locked, python), of_image, python, day, below)


def _as_locked(asked: Iterable[Requirement], locked: Iterable[Locked], python: str | None) -> Iterator[Requirement]:
    """Yield the packages, a free torch in the release of a lock, if it has one alone and ``python`` runs it."""
    found = {each.requirement.release for each in locked if each.requirement.key == "torch"}
    release = next(iter(found)) if len(found) == 1 else None
    row = framework("torch", release) if release else None
    for each in asked:
        free = each.key == "torch" and not each.release and not each.url
        if free and release and row and python and row.runs_with(python) and each.specifier.contains(release):
            yield stated(f"torch=={release}", each.origin, each.file, each.line)
        else:
            yield each


def torch_build(
    asked: Iterable[Requirement],
    cuda: str | None,
    python: str | None,
    day: str | None = None,
    why: str = "extensions are compiled with CUDA {cuda}",
    *,
    oldest: bool = False,
    below: str | None = None,
) -> Choice[Build]:
    """Return a limit for a torch that nothing pins, and the index of its wheels for this CUDA, which knows no ``day``.

    It is the newest of those wheels, ``below`` a release; the ``oldest`` where the code is older than all of them, or
    the day is.

    PyTorch refuses to compile with a toolkit of another major version than its own:
    https://github.com/pytorch/pytorch/blob/main/torch/utils/cpp_extension.py, ``_check_cuda_version``.
    """
    torch = next((each for each in asked if each.key == "torch" and not each.url), None)
    if torch is None or cuda is None:
        return Choice(answer=((), ()))
    release = Version(torch.release) if torch.release else None
    if release is not None and release.local:
        return Choice(answer=((), ()))  # its own index is known
    unpinned = None if oldest else newest_on_cuda("torch", cuda, python, day, below)
    oldest = unpinned is None
    unpinned = unpinned or oldest_on_cuda("torch", cuda, python)
    row = framework("torch", torch.release) if torch.release else unpinned
    if row is None or cuda not in row.cuda or not torch.specifier.contains(torch.release or f"{row.first}.0"):
        return Choice(answer=((), ()))
    options = () if cuda == row.cuda[0] else (_option(row, cuda),)
    if torch.release or torch.below:
        return Choice(answer=((), options))
    limit = stated(f"torch=={row.first}.*")
    which = "the oldest torch that was built with it, for code of older ones" if oldest else _NEWEST
    reason = _why(limit, f"{why.format(cuda=cuda)}: {which}", torch)
    return Choice(answer=((limit,), options), reasons=(reason,))


def newer_wheel(
    asked: Iterable[Requirement], cuda: str | None, python: str | None, day: str | None, below: str | None
) -> Choice[Build]:
    """Return the index of a torch for the image's generation of CUDA where pip's index has it for an older one.

    Nothing is compiled against it, so its wheel brings CUDA, and any of that generation, or of one between the two,
    runs with the image's driver.
    Wheels of CUDA 10 have no code for GPUs since Ampere:
    https://docs.nvidia.com/cuda/ampere-compatibility-guide/, read 2026-11-25.
    """
    torch = next((each for each in asked if each.key == "torch"), None)
    if torch is None or torch.url or cuda is None or (torch.release and Version(torch.release).local):
        return Choice(answer=((), ()))
    row = framework("torch", torch.release) if torch.release else newest_framework("torch", day, python, below)
    fits = row is not None and torch.specifier.contains(torch.release or f"{row.first}.0")
    if row is None or not fits:
        return Choice(answer=((), ()))
    between = range(Version(row.cuda[0]).major + 1, Version(cuda).major + 1)
    newer = max((each for each in row.cuda if Version(each).major in between), key=Version, default=None)
    if newer is None:
        return Choice(answer=((), ()))
    limits = () if torch.release else (stated(f"torch=={row.first}.*"),)
    why = f"PyPI has torch {torch.release or row.first} for CUDA {row.cuda[0]}, which knows no GPU since Ampere"
    reason = _why(limits[0] if limits else torch, f"{why}: that of CUDA {newer} is taken", torch)
    return Choice(answer=(limits, (_option(row, newer),)), reasons=(reason,))


def numpy_of(asked: Iterable[Requirement]) -> Choice[tuple[Requirement, ...]]:
    """Return a limit for NumPy beside a package that is installed in a release compiled before NumPy 2 existed.

    ``asked`` are the packages and their limits, which pin what the packages themselves leave free. None where NumPy
    has a limit already, or is asked for in a newer version.
    """
    asked = tuple(asked)
    numpy = [each for each in asked if each.key == "numpy"]
    if any(each.limited or not each.specifier.contains("1.26.4") for each in numpy):
        return Choice(answer=())
    for name, first in with_numpy_2().items():
        older = next((each for each in asked if each.key == name and _older(each, Version(first))), None)
        if older:
            limit = stated("numpy<2")
            why = f"{name} {older.release or f'before {older.below}'} was compiled before NumPy 2"
            place = older if older.file else None
            reason = because("dependencies", limit.written, why, place, weight=Weight.BOUND)
            return Choice(answer=(limit,), reasons=(reason,))
    return Choice(answer=())


def _older(asked: Requirement, first: Version) -> bool:
    """Tell whether every release that it allows is older than this one."""
    known = asked.release or asked.below
    return known is not None and (Version(known) < first or (not asked.release and Version(known) == first))


def _option(row: Framework, cuda: str) -> str:
    page = f"https://download.pytorch.org/whl/cu{cuda.replace('.', '')}"
    old = Version(row.first) < ONE_PAGE_BEFORE
    return f"--find-links {page}/torch_stable.html" if old else f"--extra-index-url {page}"


def _why(limit: Requirement, why: str, torch: Requirement) -> Reason:
    return because("dependencies", limit.written, why, torch if torch.file else None, weight=Weight.BOUND)
