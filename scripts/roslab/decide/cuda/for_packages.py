"""The CUDA that packages of a ROS workspace are compiled with, where Ubuntu's own toolkit is another one."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.config.model import Config
from roslab.decide.cuda.version import NO_CUDA, Cuda
from roslab.decide.cuda.weight import Weight
from roslab.decide.decision import Choice
from roslab.decide.reasons import Placed, because, outweighed, warn
from roslab.decide.ros.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.cuda_toolkits import toolkits
from roslab.knowledge.distros import Distro
from roslab.knowledge.frameworks import CudaImage, cuda_images
from roslab.values.dataclass import dataclass, replace
from roslab.values.open_ended import OF_LANGUAGES
from roslab.values.pattern import pattern
from roslab.values.version import Version

_NAMES = frozenset({"CUDA", "CUDAToolkit"})
_NUMBER = r"(\d{1,2}(?:\.\d{1,2})?)"
_RANGE = pattern(
    rf"\bcuda\b\D{{0,20}}{_NUMBER}\s*(?:-|\u2013|\u2014|~|\.\.\.?|to|through|up to)\s*{_NUMBER}(?![\w.]*\d)",
    re.IGNORECASE,
)
_LEAST = pattern(
    rf"\bcuda\b\D{{0,20}}(?:(?:>=|≥|at least|minimum)\s*{_NUMBER}"
    rf"|{_NUMBER}(?:\s*(?:\+|(?:or|and)\s+(?:above|higher|newer|later|greater|up))|{OF_LANGUAGES}))",
    re.IGNORECASE,
)
_OF_WHEELS = pattern(r"torch|tensorflow|\bpip\d?\b|conda|jax|cupy", re.IGNORECASE)


@dataclass(frozen=True, kw_only=True, slots=True)
class _Asked:
    """The versions that something asks for, and where."""

    lowest: str | None = None
    highest: str | None = None
    exact: str | None = None
    place: Placed
    words: str

    def has(self, cuda: str) -> bool:
        """Tell whether a version is among them; where one is named, newer ones are: they compile older code."""
        number = Version(cuda)
        lowest = self.exact or self.lowest
        return (lowest is None or number >= Version(lowest) or lowest == cuda.partition(".")[0]) and (
            self.highest is None or number <= Version(self.highest)
        )


def on_cuda(evidence: Evidence) -> Iterator[CMakeProject]:
    """Yield the CMake projects of packages that are built which need the compiler of CUDA."""
    folders = frozenset(manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built)
    for project in evidence.cmake:
        inside = "cuda" in project.macros and places.innermost(project.file, folders) is not None
        if inside and not places.aside(project.file):
            yield project


def for_packages(choice: Choice[Cuda], evidence: Evidence, config: Config, ros: Distro | None) -> Choice[Cuda]:
    """Return the CUDA with which packages are compiled where Ubuntu's toolkit does not fit, else the choice.

    It does not where a page or a file of CMake names other versions, or where the code is compiled for GPUs that it
    does not know. ROS is then installed into an image of CUDA.
    """
    own = toolkits().get(ros.ubuntu) if ros else None
    project = next((each for each in on_cuda(evidence) if each.cuda), None) if own else None
    authored = any("nvidia" in (each.base or "") for each in evidence.dockerfiles if each.purpose == "project")
    if ros is None or own is None or project is None or authored or config.base.cuda or config.base.image:
        return choice
    from roslab.decide.cuda.gpus import gpu_limits, knows_gpus  # noqa: PLC0415 - few trees need CUDA

    asked, limits = next(_asked(evidence), None), gpu_limits(evidence)
    if (asked is None or asked.has(own)) and knows_gpus(own, limits):
        return choice
    images = [each for each in cuda_images() if each.tag and ros.ubuntu in each.ubuntu]
    fitting = [each for each in images if (asked is None or asked.has(each.cuda)) and knows_gpus(each.cuda, limits)]
    limit = next((each for each in limits if not knows_gpus(own, (each,))), None)
    place, words = (asked.place, asked.words) if asked and not asked.has(own) else (limit or project, "")
    words = words or (f"the code is compiled for {limit.what}" if limit else "")
    if not fitting:
        message = f"{words}, but the toolkit of {ros.ubuntu} is CUDA {own}, and no image of another one is for it"
        return Choice(answer=Cuda(compiled=True), warnings=(warn(message, place),))
    taken = _best(fitting, asked).cuda
    said = f"{words}; the toolkit of {ros.ubuntu} is CUDA {own}"
    why = because("cuda", taken, said, place, weight=Weight.NEAREST)
    answer = Cuda(version=taken, cudnn=choice.answer.cudnn, cudnn_named=choice.answer.cudnn_named, compiled=True)
    return Choice(answer=answer, reasons=(why, *outweighed(choice.reasons, why)), warnings=())


def in_no_image(choice: Choice[Cuda]) -> Choice[Cuda]:
    """Return the choice of an image without NVIDIA's CUDA: none; that one without an image is asked for is told."""
    told = choice.answer.compiled or choice.answer.version is None
    return replace(NO_CUDA, warnings=choice.warnings) if told else NO_CUDA


def _best(images: list[CudaImage], asked: _Asked | None) -> CudaImage:
    """Return the one that is named, else the newest of the oldest that fits by its major version."""
    oldest = images[0]
    if asked and asked.exact:
        return oldest
    major = Version(oldest.cuda).major
    among = images if asked and asked.highest else [each for each in images if Version(each.cuda).major == major]
    return among[-1]


def _asked(evidence: Evidence) -> Iterator[_Asked]:
    """Yield what CMake asks for, then what pages say, those at the root first, then the one folder that CMake names.

    That is the author's own, and links lead from it to the toolkit that the image has.
    """
    for project in on_cuda(evidence):
        for each in project.dependencies:
            if each.namespace == "cmake" and each.name in _NAMES and each.version and each.strength == "declared":
                words = f"find_package asks for {each.name} {each.version}"
                yield _Asked(lowest=each.version, place=each, words=words)
    said = (m for m in evidence.mentions if m.topic == "cuda" and m.source == "readme")
    for mention in sorted(said, key=lambda m: m.file.count("/")):
        if not _OF_WHEELS.search(mention.text):
            yield _of_page(mention)
    paths = [each for each in evidence.mentions if each.topic == "cuda_path" and not each.inside]
    if len(paths) == 1:
        words = f"CMake names the toolkit of CUDA {paths[0].value}"
        yield _Asked(exact=paths[0].value, place=paths[0], words=words)


def _of_page(mention: Mention) -> _Asked:
    words = f"“{mention.text[:80]}”"
    if found := _RANGE.search(mention.text):
        return _Asked(lowest=found[1], highest=found[2], place=mention, words=words)
    if found := _LEAST.search(mention.text):
        return _Asked(lowest=found[1] or found[2], place=mention, words=words)
    return _Asked(exact=mention.value, place=mention, words=words)
