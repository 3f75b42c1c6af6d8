"""The CUDA of an image into which ROS is installed: one of the Ubuntu that the distribution is packaged for."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Config
from roslab.decide.base import nvidia_dockerfile
from roslab.decide.cuda.version import Cuda
from roslab.decide.cuda.weight import Weight
from roslab.decide.decision import Choice, Warning_
from roslab.decide.python.base import cuda_ubuntus
from roslab.decide.reasons import because, outweighed, warn
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import Distro
from roslab.knowledge.frameworks import cuda_image, cuda_images
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.version import Version


def with_an_image_for_distro(
    choice: Choice[Cuda], evidence: Evidence, config: Config, ros: Distro | None
) -> Choice[Cuda]:
    """Return the choice, for a CUDA without an image on the distribution's Ubuntu with the nearest that has one.

    That is the oldest newer one, else the newest older one: packages of ROS for one Ubuntu cannot be installed on
    another. Without any, ROS is installed into no image of CUDA. What only wheels bring is left as it is.
    """
    asked = choice.answer.version
    into = bool(config.base.cuda or choice.answer.compiled or (asked and nvidia_dockerfile(evidence)))
    if ros is None or asked is None or config.base.image or not into or ros.ubuntu in cuda_ubuntus(asked):
        return choice
    from roslab.decide.cuda.gpus import gpu_limits, knows_gpus  # noqa: PLC0415 - few trees need CUDA

    limits = gpu_limits(evidence)
    images = [each.cuda for each in cuda_images() if each.tag and ros.ubuntu in each.ubuntu]
    images = [cuda for cuda in images if knows_gpus(cuda, limits)] or images
    said = f"CUDA {asked} has no image for {ros.ubuntu}, which ROS {ros.name} is packaged for"
    if not images:
        told = warn(f"{said}, nor has any other: ROS's own image is taken, which has no CUDA", _place(choice))
        return replace(choice, answer=Cuda(), warnings=(*_with_image(choice.warnings, asked, ""), told))
    newer = [cuda for cuda in images if Version(cuda) >= Version(asked)]
    taken = newer[0] if newer else images[-1]
    why = because("cuda", taken, said, _place(choice), weight=Weight.NEAREST)
    answer = replace(choice.answer, version=taken)
    return replace(
        choice,
        answer=answer,
        reasons=(why, *outweighed(choice.reasons, why)),
        warnings=(*_with_image(choice.warnings, asked, taken), *_told(config, said, taken)),
    )


def _with_image(warnings: tuple[Warning_, ...], before: str, taken: str) -> Iterator[Warning_]:
    """Yield the warnings: one that says which image stands for a version without any says the one that is taken."""
    tag, other = ((row.tag if (row := cuda_image(cuda)) else "") for cuda in (before, taken))
    has = "; the image has {}. "
    for each in warnings:
        yield replace(each, message=each.message.replace(has.format(tag), has.format(other or "none")))


def _told(config: Config, said: str, taken: str) -> tuple[Warning_, ...]:
    """Return the warning to those who asked for a version themselves."""
    if not config.base.cuda:
        return ()
    at = config.origin("base.cuda") or (Place(file=config.file) if config.file else None)
    return (warn(f"{said}: {taken} is taken; name that one, or a distribution of an older Ubuntu", at),)


def _place(choice: Choice[Cuda]) -> Place | None:
    best = choice.reasons[0] if choice.reasons else None
    return Place(file=best.file, line=best.line) if best and best.file else None
