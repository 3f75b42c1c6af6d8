"""The CUDA of a torch that the code imports and nothing names: that which its wheel brings, where it is a newer one."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.cuda.version import DEFAULT, Cuda
from roslab.decide.cuda.weight import Weight
from roslab.decide.decision import Choice
from roslab.decide.python.own import OwnPython
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import cuda_image, newest_framework
from roslab.values.dataclass import replace
from roslab.values.version import Version


def for_wheels(cuda: Choice[Cuda], evidence: Evidence, config: Config, kind: Kind, own: OwnPython) -> Choice[Cuda]:
    """Return the choice, with the CUDA of the newest wheel of pip's day where nothing else names one.

    An image of the usual one suits older wheels: these bring their libraries, and the driver is the machine's.
    """
    guessed = (each for each in own.chosen.guessed if each.key == "torch" and each.origin == "import")
    torch = next((each for each in guessed if not (each.specifier or each.url)), None)
    if kind != "cuda" or cuda.answer.version or config.base.image or torch is None or own.chosen.conda:
        return cuda
    row = newest_framework("torch", evidence.pip_day, own.version)
    image = cuda_image(row.cuda[0]) if row else None
    if row is None or image is None or not image.tag or Version(image.cuda) < Version(DEFAULT):
        return cuda
    of = f" of {evidence.pip_day}" if evidence.pip_day else ""
    why = f"torch is imported and not pinned: its newest wheel{of} for Python {own.version} is for this CUDA"
    reason = because("cuda", image.cuda, why, torch, weight=Weight.UNPINNED)
    return replace(cuda, answer=replace(cuda.answer, version=image.cuda), reasons=(reason, *cuda.reasons))
