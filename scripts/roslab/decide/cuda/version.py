"""Which CUDA and cuDNN the frameworks need."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from roslab.config.model import Config
from roslab.decide.decision import Reason, Warning_
from roslab.decide.python.pins import Pin, pins
from roslab.decide.reasons import configured
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import CudaImage, cuda_image, framework, nearest_cuda_image, version

DEFAULT = "11.8"
"""Where nothing is said: the version that most frameworks of 2022 to 2025 have wheels for."""
_TABLED = {
    "tensorflow": "tensorflow",
    "tensorflow-gpu": "tensorflow",
    "torch": "torch",
    "jax": "jax",
    "jaxlib": "jax",
}
_WEIGHTS = {
    "tensorflow": ("loads it", 60),  # from the system: nothing else will do
    "torch": ("has it in its wheel", 46),
    "jax": ("is built for it", 40),
}
_BUILT_FOR = frozenset({"torch", "torchvision", "torchaudio", "torch-scatter", "mmcv-full", "jaxlib", "cupy"})
_LOCAL = re.compile(r"\+cu(\d{2,3})\b|/cu(\d{2,3})\b|[-_]cu(?:da)?(\d{2,3})\b")
_CONDA = re.compile(r"^(?:[\w-]+::)?(?:cudatoolkit|pytorch-cuda|cuda-toolkit|cuda)\s*[=<>~ ]+\s*(\d+\.\d+)")
_IMAGE = re.compile(r"(?:^|/)cuda(?:gl)?:(\d+\.\d+)|(?:^|/)[\w./-]+:[\w.-]*cuda(\d+\.\d+)")
_LEAST = re.compile(r"or (?:above|higher|newer|later|greater)|>=|≥|\d\+(?!cu)|at least|minimum", re.IGNORECASE)
_JAX = re.compile(r"jax\[cuda(1[12])")


@dataclass(frozen=True, kw_only=True, slots=True)
class CudaChoice:
    """Versions (``11.8``, ``8``), ``None`` where nothing asks for one."""

    cuda: str | None = None
    cudnn: str | None = None
    cudnn_named: bool = False
    """Something asks for cuDNN; else only frameworks need the image that has it."""
    reasons: tuple[Reason, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def decide_cuda(evidence: Evidence, config: Config) -> CudaChoice:
    """Return the CUDA and cuDNN that the repository's frameworks need; the image row of that CUDA exists."""
    if config.base.cuda:
        said = configured(config, "cuda", config.base.cuda, "base.cuda")
        return _fitted(config.base.cuda, config.base.cudnn, (said,), others=())
    found = sorted(_candidates(evidence), key=lambda item: -item[0].weight)
    if not found:
        return CudaChoice()
    best, others = found[0]
    reasons = tuple(reason if reason is best else _outweighed(reason, best) for reason, _ in found[:20])
    return _fitted(best.answer, config.base.cudnn or _cudnn(evidence), reasons, others)


def of_image(choice: CudaChoice, image: str) -> CudaChoice:
    """Return the CUDA of the author's own image, which is built as it is, where its name tells."""
    match = _IMAGE.search(image)
    named = (match[1] or match[2]) if match else choice.cuda
    if named is None or named == choice.cuda:
        return choice
    why = Reason(question="cuda", answer=named, reason=f"the author's image is {image}", weight=200)
    others = tuple(_outweighed(reason, why) for reason in choice.reasons)
    return CudaChoice(cuda=named, cudnn=choice.cudnn, reasons=(why, *others))


def _outweighed(reason: Reason, best: Reason) -> Reason:
    if reason.answer == best.answer:
        return reason
    return Reason(
        question=reason.question,
        answer=reason.answer,
        reason=reason.reason,
        file=reason.file,
        line=reason.line,
        weight=reason.weight,
        decisive=False,
    )


Candidate = tuple[Reason, tuple[str, ...]]
"""An answer, with the other CUDA versions that the same wheel exists for."""


def _candidates(evidence: Evidence) -> Iterator[Candidate]:
    """Yield every answer, whatever its weight."""
    for pin in pins(evidence):
        yield from _of_pin(pin)
    for file in evidence.requirements:
        for option in file.options:
            if file.purpose == "run" and not places.example(file.file) and (local := _local(option)):
                yield _reason(local, f"{option} serves its wheels", file.file, 1, 80), ()
    for environment in evidence.conda:
        for package in environment.packages:
            if match := _CONDA.match(package):
                weight = 75 if "/" not in environment.file else 45
                yield _reason(match[1], f"the conda environment has {package}", environment.file, 1, weight), ()
    yield from _of_dockerfiles(evidence)
    yield from _of_mentions(evidence)
    if evidence.cuda_files:
        why = "it has CUDA sources, and no version is said"
        yield _reason(DEFAULT, why, evidence.cuda_files[0], 1, 2), ()


def _reason(answer: str, why: str, file: str, line: int, weight: int) -> Reason:
    return Reason(question="cuda", answer=answer, reason=why, file=file, line=line, weight=weight)


def _local(text: str) -> str | None:
    """Return ``11.8`` for a ``+cu118`` or ``/cu118`` in a text."""
    match = _LOCAL.search(text)
    digits = next((group for group in match.groups() if group), "") if match else ""
    return f"{digits[:-1]}.{digits[-1]}" if digits else None


def _of_pin(pin: Pin) -> Iterator[Candidate]:
    file, line = pin.dependency.file, pin.dependency.line
    local = _local(pin.line) if pin.name in _BUILT_FOR else None
    if not pin.trust:  # an example's, or something deep in the tree
        row = framework(_TABLED.get(pin.name, ""), pin.release) if pin.release else None
        if answer := local or (row.cuda[0] if row else None):
            yield _reason(answer, f"{pin.line} goes with it", file, line, 3), ()
    elif local:
        yield _reason(local, f"{pin.line} is built for it", file, line, 82 + pin.trust), ()
    elif named := _JAX.search(pin.line):
        yield _reason("11.8" if named[1] == "11" else "12.3", f"{pin.line} names it", file, line, 70 + pin.trust), ()
    elif pin.release and pin.name in _TABLED and (row := framework(_TABLED[pin.name], pin.release)):
        why, weight = _WEIGHTS[_TABLED[pin.name]]
        text = f"{pin.name} {pin.release} {why}"
        yield _reason(row.cuda[0], text, file, line, weight + 3 * pin.trust), row.cuda[1:]
    elif pin.trust and pin.name in _TABLED and (row := framework(_TABLED[pin.name], None)):
        yield _reason(row.cuda[0], f"{pin.name} is not pinned: its newest wheel", file, line, 4), row.cuda[1:]


def _of_dockerfiles(evidence: Evidence) -> Iterator[Candidate]:
    for authored in evidence.dockerfiles:
        match = _IMAGE.search(authored.base or "")
        if match and authored.purpose in {"project", "deploy", "broken"}:
            weight = (62 if authored.purpose == "project" else 20) + (3 if authored.copies_repository else 0)
            why = f"the author's image starts from {authored.base}"
            yield _reason(match[1] or match[2], why, authored.file, authored.base_line, weight), ()


def _of_mentions(evidence: Evidence) -> Iterator[Candidate]:
    for mention in evidence.mentions:
        if mention.topic == "cuda" and version(mention.value) >= (8,):
            nearness = 6 - 2 * min(mention.file.count("/"), 3)
            weight = {"readme": 30, "ci": 14, "dockerfile": 12, "script": 16}.get(mention.source, 8) + nearness
            if mention.source == "readme" and _LEAST.search(mention.text):
                weight = 3  # a lower bound: what is pinned, or the newest wheel, lies above it
            yield _reason(mention.value, f"“{mention.text[:80]}”", mention.file, mention.line, weight), ()


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
    note = Reason(
        question="cuda",
        answer=instead.cuda,
        reason=f"CUDA {cuda} was asked for, but {why}; this is the nearest that can be built",
        weight=101,
    )
    warning = Warning_(
        message=f"CUDA {cuda}: {why}; the image has {instead.cuda}. A framework that loads CUDA {cuda} itself will "
        "not see the GPU; set base.cuda or base.image in roslab.yaml to choose another",
        file=reasons[0].file,
        line=reasons[0].line,
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
