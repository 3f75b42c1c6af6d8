"""The CUDA of extensions of torch for which nobody names one: that of a torch which pip can take."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.cuda.toolkit import extends_torch
from roslab.decide.cuda.version import DEFAULT, Cuda
from roslab.decide.cuda.weight import Weight
from roslab.decide.decision import Choice
from roslab.decide.python.own import OwnPython
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import cuda_image, newest_framework
from roslab.values.dataclass import replace
from roslab.values.version import Version


def for_extensions(cuda: Choice[Cuda], evidence: Evidence, config: Config, kind: Kind, own: OwnPython) -> Choice[Cuda]:
    """Return the choice, with the usual version where nothing names one and something is compiled against torch.

    It is the newest of the wheels of pip's day where these are older. Without one pip takes a torch of any CUDA, which
    the compiler of the image then refuses.
    """
    if kind != "cuda" or cuda.answer.version or config.base.image or not extends_torch(evidence, own.chosen):
        return cuda
    row = newest_framework("torch", evidence.pip_day, own.version)
    built = [each for each in row.cuda if (image := cuda_image(each)) and image.tag] if row else []
    version = DEFAULT if DEFAULT in built or not built else max(built, key=Version)
    why = "extensions are compiled against torch, no version is named"
    reason = because("cuda", version, why, weight=Weight.SOURCES)
    return replace(cuda, answer=replace(cuda.answer, version=version), reasons=(reason, *cuda.reasons))
