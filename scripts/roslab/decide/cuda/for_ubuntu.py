"""The CUDA of code for which nobody names one: its image must exist for the Ubuntu that the author names."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.base import named_ubuntus
from roslab.decide.cuda.version import DEFAULT, Cuda
from roslab.decide.cuda.weight import Weight
from roslab.decide.decision import Choice
from roslab.decide.reasons import because, outweighed
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import cuda_image, cuda_images
from roslab.values.dataclass import replace
from roslab.values.origin import Place


def with_an_image_for(
    cuda: Choice[Cuda], evidence: Evidence, config: Config, kind: Kind, python: str | None
) -> Choice[Cuda]:
    """Return the choice, for a mere default with a version that has an image for a named Ubuntu, on which it compiles.

    It is the newest older one, else the oldest newer one. A program of Python runs on the Ubuntu of its Python.
    """
    best = cuda.reasons[0] if cuda.reasons else None
    usual = cuda_image(DEFAULT)
    if kind != "cuda" or python is not None or config.base.ubuntu or config.base.image:
        return cuda
    if best is None or best.weight > Weight.SOURCES or best.answer != DEFAULT or usual is None:
        return cuda
    from roslab.decide.cuda.gpus import gpu_limits, knows_gpus  # noqa: PLC0415 - few trees need CUDA

    images = [image for image in cuda_images() if image.tag and knows_gpus(image.cuda, gpu_limits(evidence))]
    order = images.index(usual) if usual in images else len(images)
    nearest = (*reversed(images[: order + 1]), *images[order + 1 :])
    for reason in named_ubuntus(evidence, config):
        image = next((image for image in nearest if reason.answer in image.ubuntu), None)
        if image == usual:
            return cuda
        if image:
            place = Place(file=reason.file, line=reason.line) if reason.file else None
            said = f"nobody names a version, and {DEFAULT} has no image for {reason.answer}"
            why = because("cuda", image.cuda, said, place, weight=Weight.NEAREST)
            answer = replace(cuda.answer, version=image.cuda)
            return replace(cuda, answer=answer, reasons=(why, *outweighed(cuda.reasons, why)))
    return cuda
