"""A torch that a page only names and that is older than every CUDA with an image: it compiles nothing there."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.knowledge.frameworks import framework, released_together
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version


def older_torch(asked: Iterable[Requirement], cuda: str | None) -> str | None:
    """Return the release of a torch in a list or a sentence of a page whose wheels are all for an older CUDA.

    Such a torch refuses to compile for the GPUs of CUDA 11 (https://github.com/lkeab/BCNet/issues/23, read 2026-11-23).
    What a command or a manifest pins is meant as it stands.
    """
    said = (each.release for each in asked if each.key == "torch" and each.role == "listed" and each.release)
    return next((release for release in said if cuda is not None and _before(release, cuda)), None)


def without_release(guessed: Iterable[Requirement]) -> tuple[Requirement, ...]:
    """Return the guesses with the torch that a page lists, and what is released with it, without their releases."""
    family = {"torch", *released_together().get("torch", ())}
    return tuple(
        stated(each.name, each.origin, each.file, each.line, role=each.role)
        if each.key in family and each.role == "listed"
        else each
        for each in guessed
    )


def _before(release: str, cuda: str) -> bool:
    row = framework("torch", release)
    return row is not None and all(Version(each) < Version(cuda) for each in row.cuda)
