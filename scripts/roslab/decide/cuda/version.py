"""Which CUDA and cuDNN the frameworks need."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from packaging.version import Version

from roslab.config.model import Config
from roslab.decide.cuda.local import cuda_of
from roslab.decide.decision import Reason, Warning_
from roslab.decide.python.pins import Pin
from roslab.decide.reasons import because, configured, outweighed, warn
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import (
    CudaImage,
    cuda_image,
    framework,
    framework_on_cuda,
    nearest_cuda_image,
    newest_framework,
)  # fmt: skip
from roslab.values.origin import Place
from roslab.values.version import minor_of, version_of

DEFAULT = "11.8"
"""Where nothing is said: the version that most frameworks of 2022 to 2025 have wheels for."""
_OLDEST = Version("8")
_WEIGHTS = {
    "tensorflow": ("loads it", 60),  # from the system: nothing else will do
    "torch": ("has it in its wheel", 46),
    "jax": ("is built for it", 40),
}
_BUILT_FOR = frozenset({"torch", "torchvision", "torchaudio", "torch-scatter", "mmcv-full", "jaxlib", "cupy"})
_OF_CONDA = frozenset({"cudatoolkit", "pytorch-cuda", "cuda-toolkit", "cuda"})
_OF_JAX = {"cuda11": "11.8", "cuda12": "12.3"}
"""By how an extra of JAX begins. https://docs.jax.dev/en/latest/installation.html, read 2026-08-22."""
_IMAGE = re.compile(r"(?:^|/)cuda(?:gl)?:(\d+\.\d+)|(?:^|/)[\w./-]+:[\w.-]*cuda(\d+\.\d+)")
_LEAST = re.compile(r"or (?:above|higher|newer|later|greater)|>=|≥|\d\+(?!cu)|at least|minimum", re.IGNORECASE)
_SHOWN = 20
"""Reasons that are kept of all that name a CUDA."""


@dataclass(frozen=True, kw_only=True, slots=True)
class CudaChoice:
    """Versions (``11.8``, ``8``), ``None`` where nothing asks for one."""

    cuda: str | None = None
    cudnn: str | None = None
    cudnn_named: bool = False
    """Something asks for cuDNN; else only frameworks need the image that has it."""
    reasons: tuple[Reason, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def decide_cuda(evidence: Evidence, config: Config, pins: tuple[Pin, ...]) -> CudaChoice:
    """Return the CUDA and cuDNN that the repository's frameworks need; the image row of that CUDA exists."""
    if config.base.cuda:
        said = configured(config, "cuda", config.base.cuda, "base.cuda")
        return _fitted(config.base.cuda, config.base.cudnn, (said,), others=())
    found = sorted(_candidates(evidence, pins), key=lambda item: -item[0].weight)
    if not found:
        return CudaChoice()
    best, others = found[0]
    reasons = outweighed((reason for reason, _ in found[:_SHOWN]), best)
    return _fitted(best.answer, config.base.cudnn or _cudnn(evidence), reasons, others)


def of_image(choice: CudaChoice, image: str) -> CudaChoice:
    """Return the CUDA of the author's own image, which is built as it is, where its name tells."""
    match = _IMAGE.search(image)
    named = (match[1] or match[2]) if match else choice.cuda
    if named is None or named == choice.cuda:
        return choice
    why = because("cuda", named, f"the author's image is {image}", weight=200)
    return CudaChoice(cuda=named, cudnn=choice.cudnn, reasons=(why, *outweighed(choice.reasons, why)))


Candidate = tuple[Reason, tuple[str, ...]]
"""An answer, with the other CUDA versions that the same wheel exists for."""


def _candidates(evidence: Evidence, pins: Iterable[Pin]) -> Iterator[Candidate]:
    """Yield every answer, whatever its weight."""
    for pin in pins:
        yield from _of_pin(pin)
    for file in evidence.requirements:
        for option in file.options:
            if file.purpose == "run" and not places.example(file.file) and (local := cuda_of(option)):
                yield because("cuda", local, f"{option} serves its wheels", file, weight=80), ()
    for environment in evidence.conda:
        for package in environment.packages:
            if package.name in _OF_CONDA and (cuda := minor_of(package.version)):
                why = f"the conda environment has {package.written}"
                yield because("cuda", cuda, why, environment, weight=75 if "/" not in environment.file else 45), ()
    yield from _of_dockerfiles(evidence)
    yield from _of_mentions(evidence)
    if evidence.cuda_files:
        place = Place(file=evidence.cuda_files[0], line=1)
        yield because("cuda", DEFAULT, "it has CUDA sources, and no version is said", place, weight=2), ()


def _of_pin(pin: Pin) -> Iterator[Candidate]:
    """Yield the CUDA that a wheel names, or the one that the table has for its release."""
    asked, table = pin.requirement, framework_on_cuda(pin.name)
    local = (cuda_of(asked.url) or cuda_of(pin.release or "")) if pin.name in _BUILT_FOR else None
    row = framework(table, pin.release) if table and pin.release else None
    if not pin.trust:  # an example's, or something deep in the tree
        if answer := local or (row.cuda[0] if row else None):
            yield because("cuda", answer, f"{asked.written} goes with it", asked, weight=3), ()
    elif local:
        yield because("cuda", local, f"{asked.written} is built for it", asked, weight=82 + pin.trust), ()
    elif pin.name == "jax" and (named := next((_OF_JAX[e[:6]] for e in asked.extras if e[:6] in _OF_JAX), None)):
        yield because("cuda", named, f"{asked.written} names it", asked, weight=70 + pin.trust), ()
    elif row and table:
        why, weight = _WEIGHTS[table]
        text = f"{pin.name} {pin.release} {why}"
        yield because("cuda", row.cuda[0], text, asked, weight=weight + 3 * pin.trust), row.cuda[1:]
    elif table and (newest := newest_framework(table)):
        why = f"{pin.name} is not pinned: its newest wheel"
        yield because("cuda", newest.cuda[0], why, asked, weight=4), newest.cuda[1:]


def _of_dockerfiles(evidence: Evidence) -> Iterator[Candidate]:
    for authored in evidence.dockerfiles:
        match = _IMAGE.search(authored.base or "")
        if match and authored.purpose in {"project", "deploy", "broken"}:
            weight = (62 if authored.purpose == "project" else 20) + (3 if authored.copies_repository else 0)
            why = f"the author's image starts from {authored.base}"
            place = Place(file=authored.file, line=authored.base_line)
            yield because("cuda", match[1] or match[2], why, place, weight=weight), ()


def _of_mentions(evidence: Evidence) -> Iterator[Candidate]:
    for mention in evidence.mentions:
        number = version_of(mention.value) if mention.topic == "cuda" else None
        if number and number >= _OLDEST:
            nearness = 6 - 2 * min(mention.file.count("/"), 3)
            weight = {"readme": 30, "ci": 14, "dockerfile": 12, "script": 16}.get(mention.source, 8) + nearness
            if mention.source == "readme" and _LEAST.search(mention.text):
                weight = 3  # a lower bound: what is pinned, or the newest wheel, lies above it
            yield because("cuda", mention.value, f"“{mention.text[:80]}”", mention, weight=weight), ()


def _cudnn(evidence: Evidence) -> str | None:
    return next((mention.value for mention in evidence.mentions if mention.topic == "cudnn"), None)


def _fitted(cuda: str, cudnn: str | None, reasons: tuple[Reason, ...], others: tuple[str, ...]) -> CudaChoice:
    """Keep a version whose images exist; else another wheel's, else the nearest newer one, with a warning."""
    image = cuda_image(cuda)
    if image is not None and image.tag:
        return CudaChoice(cuda=image.cuda, cudnn=_digits(image, cudnn), cudnn_named=bool(cudnn), reasons=reasons)
    instead = next((row for other in others if (row := cuda_image(other)) and row.tag), None) or nearest_cuda_image(
        cuda
    )
    why = "its images were deleted from the registry" if image else "no image of it is known"
    note = because(
        "cuda",
        instead.cuda,
        f"CUDA {cuda} was asked for, but {why}; this is the nearest that can be built",
        weight=101,
    )
    said = reasons[0]
    warning = warn(
        f"CUDA {cuda}: {why}; the image has {instead.cuda}. A framework that loads CUDA {cuda} itself will "
        "not see the GPU; set base.cuda or base.image in roslab.yaml to choose another",
        Place(file=said.file, line=said.line) if said.file else None,
    )
    return CudaChoice(
        cuda=instead.cuda,
        cudnn=_digits(instead, cudnn),
        cudnn_named=bool(cudnn),
        reasons=(*reasons, note),
        warnings=(warning,),
    )


def _digits(image: CudaImage, cudnn: str | None) -> str | None:
    """Return the cuDNN that the image has: its tag names one version, later ones are 9."""
    return image.cudnn.removeprefix("cudnn") or ("9" if image.cudnn else cudnn)
