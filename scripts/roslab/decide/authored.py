"""What the author's own Dockerfile, where that is built, decides in place of the program."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.base import BaseImage, of_dockerfile
from roslab.decide.cuda.version import Cuda, of_image
from roslab.decide.decision import Choice, MendedBase
from roslab.decide.python.image_python import Python
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def as_authored(
    dockerfile: str | None,
    evidence: Evidence,
    config: Config,
    mended: tuple[MendedBase, ...],
    *,
    base: Choice[BaseImage],
    cuda: Choice[Cuda],
    python: Choice[Python],
) -> tuple[Choice[BaseImage], Choice[Cuda], Choice[Python]]:
    """Return the choices as they are, or, with a ``dockerfile``, its base and CUDA; it brings a Python of its own."""
    if dockerfile is None:
        return base, cuda, python
    base = of_dockerfile(base, evidence, config, dockerfile, mended)
    said = tuple(reason for reason in python.reasons if reason.question != "python")
    return base, of_image(cuda, base.answer.image), replace(python, reasons=said)
