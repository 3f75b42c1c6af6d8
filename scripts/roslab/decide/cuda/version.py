"""Which CUDA and cuDNN the frameworks need."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.config.model import Config
from roslab.decide.cuda.above_lock import above, cuda_of_lock
from roslab.decide.cuda.beside_torch import conda_torch
from roslab.decide.cuda.conda_builds import BUILT_FOR, OF_CONDA, built_for, names_cuda
from roslab.decide.cuda.for_libtorch import CUDNN, for_libtorch
from roslab.decide.cuda.imported import imported
from roslab.decide.cuda.local import cuda_of, cuda_of_build, of_the_cpu
from roslab.decide.cuda.outdone import outdone
from roslab.decide.cuda.weight import Weight
from roslab.decide.decision import Choice, Reason
from roslab.decide.python.pins import DEVELOPMENT, Pin
from roslab.decide.python.pythons import DEFAULT as PYTHON
from roslab.decide.python.version import python_version
from roslab.decide.reasons import because, configured, outweighed, warn
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.accelerated import cuda_of_jax, without_gpu
from roslab.knowledge.frameworks import (
    CudaImage,
    build_needs,
    cuda_image,
    framework_on_cuda,
    meant_framework,
    nearest_cuda_image,
    newest_framework,
    tabled,
)  # fmt: skip
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern
from roslab.values.version import Version, minor_of, version_of

DEFAULT = "11.8"
"""The version when nothing names one: most frameworks of 2022 to 2025 have wheels for it."""
_OLDEST = Version("8")
_WHY = {"tensorflow": "loads it", "torch": "has it in its wheel", "jax": "is built for it"}
_CONDA_HAS = "the conda environment has"
_IMAGE = pattern(r"(?:^|/)cuda(?:gl)?:(\d+\.\d+)|(?:^|/)[\w./-]+:[\w.-]*cuda(\d+\.\d+)")
_LEAST = pattern(r"or (?:above|higher|newer|later|greater)|>=|≥|\d\+(?!cu)|at least|minimum", re.IGNORECASE)
_SHOWN = 20
"""Most reasons that are kept."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Cuda:
    """CUDA and cuDNN versions (``11.8``, ``8``), ``None`` where nothing asks for one."""

    version: str | None = None
    cudnn: str | None = None
    cudnn_named: bool = False
    """Something asks for cuDNN; otherwise only frameworks need the image with it."""
    compiled: bool = False
    """Packages of ROS are compiled with it, for which Ubuntu's own toolkit does not do."""


NO_CUDA: Choice[Cuda] = Choice(answer=Cuda())


def decide_cuda(evidence: Evidence, config: Config, pins: tuple[Pin, ...]) -> Choice[Cuda]:
    """Return the CUDA and cuDNN that the repository's frameworks need; an image of that CUDA exists."""
    if config.base.cuda:
        said = configured(config, "cuda", config.base.cuda, "base.cuda")
        return _fitted(config.base.cuda, config.base.cudnn, (said,), others=())
    candidates = _candidates(evidence, config, pins)
    found = sorted(candidates, key=lambda item: (-item[0].weight, not _has_image(item[0].answer)))
    if not found:
        return NO_CUDA
    best, others = _known_to_compiler(found, evidence)
    shown = [reason for reason, _ in found[:_SHOWN]]
    reasons = outweighed(shown if best in shown else [best, *shown], best)
    choice = _fitted(best.answer, config.base.cudnn or _cudnn(evidence), reasons, others)
    from roslab.decide.cuda.gpus import gpu_limits, unknown_gpu  # noqa: PLC0415 - few trees need CUDA

    lost = unknown_gpu(choice.answer.version, gpu_limits(evidence))
    return replace(choice, warnings=(*choice.warnings, lost)) if lost else choice


def _has_image(cuda: str) -> bool:
    """Tell whether an image of a CUDA exists: of two ways to install the same, the other one cannot be built."""
    image = cuda_image(cuda)
    return image is not None and bool(image.tag)


def _known_to_compiler(found: list[Candidate], evidence: Evidence) -> Candidate:
    """Return the best answer whose compiler knows every GPU that the code names, else the nearest to the best."""
    from roslab.decide.cuda.gpus import gpu_limits, knows_gpus, nearest_that_knows  # noqa: PLC0415 - as above

    limits, best = gpu_limits(evidence), found[0]
    named = (each for each in found if each is best or each[0].weight > Weight.SOURCES)
    fitting = next((each for each in named if knows_gpus(each[0].answer, limits)), None)
    if fitting:
        return fitting
    reason = nearest_that_knows(best[0], limits)
    return (reason, ()) if reason else best


def of_image(choice: Choice[Cuda], image: str) -> Choice[Cuda]:
    """Return the choice with the CUDA that the name of the author's base image tells, if it does."""
    match = _IMAGE.search(image)
    named = (match[1] or match[2]) if match else choice.answer.version
    if named is None or named == choice.answer.version:
        return choice
    why = because("cuda", named, f"the author's image is {image}", weight=Weight.OWN_IMAGE)
    answer = Cuda(version=named, cudnn=choice.answer.cudnn)
    return Choice(answer=answer, reasons=(why, *outweighed(choice.reasons, why)))


Candidate = tuple[Reason, tuple[str, ...]]
"""An answer, with the other CUDA versions that the same wheel exists for."""


def _candidates(evidence: Evidence, config: Config, pins: tuple[Pin, ...]) -> Iterator[Candidate]:
    """Yield every answer that anything speaks for."""
    day, python = evidence.pip_day, python_version(evidence, config, pins).answer.version
    if not day and python is None:  # for the default pip takes an older release than the newest
        python = PYTHON
    compiles = bool(evidence.cuda_files) or any("cuda" in project.extensions for project in evidence.python)
    compiles = compiles or any("torch" in build_needs().get(pin.name, ()) for pin in pins)
    lowest = {use.bound.key: use.bound.below for use in evidence.bounds}
    of_conda = {each.file for each in evidence.conda if any(map(names_cuda, each.packages))}
    of_cpu = {(each.file, name) for each in evidence.conda for name, cpu in built_for(each) if cpu}
    for pin in (*pins, *imported(evidence, pins)):
        file = pin.requirement.file
        if pin.requirement.role == "conda" and (file in of_conda or (file, pin.name) in of_cpu):
            continue  # conda has it for the CUDA that the same file names, or for none
        counted = replace(pin, trust=0) if outdone(pin, pins) else pin
        yield from _of_pin(counted, day, python, lowest.get(tabled(pin.name)), compiles=compiles)
    locked = None if compiles else cuda_of_lock(evidence)
    yield from (each for each in _of_indexes(evidence) if not above(each[0].answer, locked))
    yield from _of_conda(evidence)
    yield from _of_dockerfiles(evidence)
    if taken := for_libtorch(evidence):
        said, of_archive = taken
        why = f"{said.text} is taken, which is built for it"
        yield because("cuda", of_archive, why, said, weight=Weight.LOCAL_VERSION), ()
    yield from (each for each in _of_mentions(evidence) if not above(each[0].answer, locked))
    if evidence.cuda_files:
        place = Place(file=evidence.cuda_files[0], line=1)
        yield because("cuda", DEFAULT, "it has CUDA sources, no version is named", place, weight=Weight.SOURCES), ()


def _of_conda(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the CUDA that an environment names, as a package or in the build string of a framework."""
    for environment in (each for each in evidence.conda if not places.vendored(each.file)):
        for package in environment.packages:
            if not names_cuda(package):
                continue
            below, cuda = "/" in environment.file, minor_of(package.version)
            weight = Weight.CONDA_BELOW if below else Weight.CONDA
            if package.name not in OF_CONDA:
                cuda = cuda_of_build(package.build)
                weight = weight if environment.file.count("/") > 1 else Weight.LOCAL_VERSION
            if cuda:
                yield because("cuda", cuda, f"{_CONDA_HAS} {package.written}", environment, weight=weight), ()


def _of_indexes(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the CUDA of the wheels in an index that a requirements file, or a line of a page, names."""
    for file in evidence.requirements:
        for option in file.options:
            if file.purpose == "run" and not places.example(file.file) and (local := cuda_of(option)):
                yield because("cuda", local, f"pip uses {option}", file, weight=Weight.WHEEL_INDEX), ()
    for asked in evidence.prose_pip:
        if asked.role == "option" and not DEVELOPMENT.search(asked.file) and (local := cuda_of(asked.written)):
            weight = Weight.WHEEL_INDEX - Weight.DEEPER * min(asked.file.count("/"), 3)
            yield because("cuda", local, f"pip uses {asked.written}", asked, weight=weight), ()


def _of_pin(pin: Pin, day: str | None, python: str | None, below: str | None, *, compiles: bool) -> Iterator[Candidate]:
    """Yield the CUDA that a wheel names, or the one of its release: the newest of ``day`` that ``python`` runs.

    That is ``below`` the first release which lacks what the code uses, or which the requirement excludes. A wheel of
    torch brings its CUDA: nothing but what ``compiles`` needs the same one in the image.
    """
    asked, table = pin.requirement, framework_on_cuda(pin.name)
    local = (cuda_of(asked.url) or cuda_of(pin.release or "")) if pin.name in BUILT_FOR else None
    release = pin.release or ""
    cpu = of_the_cpu(release) or without_gpu(pin.name, release)
    row = meant_framework(table, release) if table and release and not cpu else None
    if not pin.trust:  # from a lock, from an example, or deep in the tree
        weight = Weight.LOCKED if asked.origin == "lock" else Weight.ASIDE
        if answer := local or (row.cuda[0] if row else None):
            yield because("cuda", answer, f"{asked.written} is used with it", asked, weight=weight), ()
    elif local:
        yield (
            because("cuda", local, f"{asked.written} is built for it", asked, weight=Weight.LOCAL_VERSION + pin.trust),
            (),
        )
    elif named := cuda_of_jax(pin.name, asked.extras):
        yield because("cuda", named, f"{asked.written} names it", asked, weight=Weight.EXTRA + pin.trust), ()
    elif row and table:
        why = f"{pin.name} {pin.release} {_WHY[table]}"
        weight = Weight.RELEASE[table] + Weight.TRUST * pin.trust
        yield because("cuda", row.cuda[0], why, asked, weight=weight), row.cuda[1:]
    elif (
        table
        and not release
        and asked.role != "listed"
        and (newest := newest_framework(table, day, python, _lower(below, asked.below)))
        and not without_gpu(pin.name, newest.first)
    ):
        of, runs = f" of {day}" if day else "", f" for Python {python}" if python else ""
        why = f"{pin.name} is not pinned: its newest wheel{of}{runs}"
        if table == "torch" and not compiles:
            from roslab.decide.cuda.of_wheel import of_wheel  # noqa: PLC0415 - few trees need CUDA

            answer, what = of_wheel(newest)
            why = f"{why} is {newest.package} {newest.first} with {what}"
            yield because("cuda", answer, why, asked, weight=Weight.UNPINNED), ()
        else:
            why = f"{why} is for this CUDA"
            yield because("cuda", newest.cuda[0], why, asked, weight=Weight.UNPINNED), newest.cuda[1:]


def _lower(below: str | None, other: str | None) -> str | None:
    return min((each for each in (below, other) if each), key=Version, default=None)


def _of_dockerfiles(evidence: Evidence) -> Iterator[Candidate]:
    for authored in evidence.dockerfiles:
        match = _IMAGE.search(authored.base or "")
        if match and authored.purpose in {"project", "deploy", "broken"}:
            from roslab.decide.cuda.upstream_images import of_upstream  # noqa: PLC0415 - few trees have an image of CUDA

            own = authored.purpose == "project" and not of_upstream(evidence, authored)
            weight = Weight.AUTHORS_IMAGE if own else Weight.OTHER_IMAGE
            weight += Weight.COPIES if authored.copies_repository else 0
            why = f"the author's image starts from {authored.base}"
            place = Place(file=authored.file, line=authored.base_line)
            yield because("cuda", match[1] or match[2], why, place, weight=weight), ()


def _of_mentions(evidence: Evidence) -> Iterator[Candidate]:
    torch = conda_torch(evidence)
    for mention in evidence.mentions:
        number = version_of(mention.value) if mention.topic == "cuda" else None
        if number and number >= _OLDEST:
            nearness = Weight.NEAR - Weight.DEEPER * min(mention.file.count("/"), 3)
            weight = Weight.SAID.get(mention.source, Weight.SAID_ELSEWHERE) + nearness
            if mention.source == "readme" and _LEAST.search(mention.text):
                weight = Weight.AT_LEAST
            if (mention.file, mention.line) in torch:  # conda takes the torch that was built for it
                weight = Weight.LOCAL_VERSION + 1 - Weight.DEEPER * min(mention.file.count("/"), 3)
            yield because("cuda", mention.value, f"“{mention.text[:80]}”", mention, weight=weight), ()


def _cudnn(evidence: Evidence) -> str | None:
    """Return the cuDNN that is named, or the oldest that libtorch's own configuration for CMake takes."""
    named = next((mention.value for mention in evidence.mentions if mention.topic == "cudnn"), None)
    return named or (CUDNN if for_libtorch(evidence) else None)


def _fitted(cuda: str, cudnn: str | None, reasons: tuple[Reason, ...], others: tuple[str, ...]) -> Choice[Cuda]:
    """Keep a version that has images; else take another wheel's version, else the nearest newer one, with a warning."""
    image = cuda_image(cuda)
    if image is not None and image.tag:
        return Choice(answer=_cuda(image, cudnn), reasons=reasons)
    accepted = next((row for other in others if (row := cuda_image(other)) and row.tag), None)
    instead = accepted or nearest_cuda_image(cuda)
    why = "its images were deleted from the registry, its last patch's too" if image else "no image of it is known"
    if others:
        having = accepted.cuda if accepted else "none"
        why += f"; of {', '.join(others)}, which the framework accepts too, {having} has one"
    nearest = f"CUDA {cuda} would be taken, but {why}; this is the nearest that can be built"
    note = because("cuda", instead.cuda, nearest, weight=Weight.NEAREST)
    said = reasons[0]
    loads = f"A framework that loads CUDA {cuda} itself will not see the GPU; set"
    if said.reason.endswith(_WHY["torch"]):
        loads = "The wheel loads its own; set"
    elif said.reason.startswith(_CONDA_HAS):
        loads = f"What conda installs loads its own, but what is compiled in the image is for {instead.cuda}; set"
    message = f"CUDA {cuda}: {why}; the image has {instead.tag}. {loads} base.cuda or base.image in roslab.yaml"
    place = Place(file=said.file, line=said.line) if said.file else None
    warning = warn(f"{message} to choose another", place)
    return Choice(answer=_cuda(instead, cudnn), reasons=(*reasons, note), warnings=(warning,))


def _cuda(image: CudaImage, cudnn: str | None) -> Cuda:
    """Return an image's versions: its tag names one cuDNN, a later image has 9."""
    digits = image.cudnn.removeprefix("cudnn") or ("9" if image.cudnn else cudnn)
    return Cuda(version=image.cuda, cudnn=digits, cudnn_named=bool(cudnn))
