"""Which platforms the image can be built for."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Config, Kind, Source
from roslab.decide.cuda.version import DEFAULT as CUDA
from roslab.decide.decision import Choice, Reason
from roslab.decide.processor import OnX86
from roslab.decide.python.image_python import Python
from roslab.decide.reasons import Placed, because, configured, warn
from roslab.decide.ros.source_names import address
from roslab.decide.system.needs import TOOLKIT
from roslab.evidence.facts import Evidence
from roslab.knowledge.accelerated import accelerated
from roslab.knowledge.arm64 import amd64_only, arm64_since, arm64_wheels
from roslab.knowledge.cuda_toolkits import toolkits_for_arm64
from roslab.knowledge.distros import distro
from roslab.values.dataclass import dataclass, replace
from roslab.values.native_part import NativePart
from roslab.values.requirement import Requirement
from roslab.values.version import Version, version_of

AMD64, ARM64 = "linux/amd64", "linux/arm64"


class Weight:
    """How much each reason for the platforms counts."""

    AGAINST = 50  # one thing without arm64 is enough
    NOTHING_AGAINST = 10


@dataclass(frozen=True, kw_only=True, slots=True)
class Platforms:
    """Platforms to build, and ``(platform, why not)`` for those left out."""

    built: tuple[str, ...] = (AMD64, ARM64)
    refused: tuple[tuple[str, str], ...] = ()
    without: tuple[str, ...] = ()
    """Options of the compiler that are left out for arm64."""


Against = tuple[str, Placed | None]
"""Why there can be no arm64 image, and the place that shows it."""


def decide_platforms(  # noqa: PLR0917 - the order in which the questions are answered
    evidence: Evidence,
    config: Config,
    kind: Kind,
    base_image: str,
    ros_distro: str | None,
    cuda: str | None,
    python: Python,
    installed: tuple[Requirement, ...],
    on_x86: OnX86,
    sources: Iterable[Source] = (),
    *,
    apt: Iterable[str] = (),
    ubuntu: str | None = None,
) -> Choice[Platforms]:
    """Return the platforms that can exist: amd64 always, arm64 where the base, CUDA and every pinned wheel have it."""
    if config.platforms is not None:
        said = configured(config, "platforms", ", ".join(config.platforms), "platforms")
        return _without(Platforms(built=config.platforms), said, on_x86)
    against = (
        _of_base(base_image, ros_distro)
        or _of_cuda(kind, base_image, cuda, python)
        or _of_toolkit(apt, ubuntu)
        or _of_wheels(python, installed)
        or _of_conda(evidence, python)
        or _of_archives(sources, python.native_parts)
        or _of_vendors(sources)
        or _of_code(on_x86)
    )
    if against is None:
        why = f"{base_image} exists for both platforms, and nothing rules one out"
        if "/" in base_image and not base_image.startswith("nvidia/cuda"):
            why = f"nothing rules one out; whether {base_image} exists for both was not looked at"
        both = because("platforms", f"{AMD64}, {ARM64}", why, weight=Weight.NOTHING_AGAINST)
        return _without(Platforms(), both, on_x86)
    why, place = against
    one = because("platforms", AMD64, f"no {ARM64}: {why}", place, weight=Weight.AGAINST)
    return Choice(answer=Platforms(built=(AMD64,), refused=((ARM64, why),)), reasons=(one,))


def _without(platforms: Platforms, reason: Reason, on_x86: OnX86) -> Choice[Platforms]:
    """Leave out the options that arm64 does not know, and tell it."""
    if ARM64 not in platforms.built or not on_x86.left_out:
        return Choice(answer=platforms, reasons=(reason,))
    words = tuple(dict.fromkeys(each.what for each in on_x86.left_out))
    message = (
        f"{', '.join(words)}: only x86 has it; the image for {ARM64} is compiled without it, as no code asks for it"
    )
    told = warn(message, on_x86.left_out[0])
    return Choice(answer=replace(platforms, without=words), reasons=(reason,), warnings=(told,))


def _of_archives(sources: Iterable[Source], parts: Iterable[NativePart]) -> Against | None:
    known = amd64_only("archive")
    found = next((source for source in sources if source.zip and source.zip.startswith(known)), None)
    if found:
        return f"{found.name} is an archive for amd64 only", found.place
    part = next((part for part in parts if not part.guessed and part.archive.startswith(known)), None)
    return (f"{part.name}, which {part.package} needs, is an archive for amd64 only", None) if part else None


def _of_vendors(sources: Iterable[Source]) -> Against | None:
    known = {address(each) for each in amd64_only("source")}
    for source in sources:
        if source.repo and address(source.repo) in known:
            return f"{source.name} brings libraries for amd64 only", source.place
        makefile = f"{source.repo.removesuffix('.git')}/{source.cmake_folder}" if source.repo and source.by_make else ""
        if makefile and address(makefile) in known:
            return f"the Makefile in {source.cmake_folder} of {source.name} is for amd64 only", source.place
    return None


def _of_code(on_x86: OnX86) -> Against | None:
    if on_x86.needed is None:
        return None
    if on_x86.needed.source == "binary":
        return f"CMake takes {on_x86.needed.what}, which is for amd64 only, on every processor", on_x86.needed
    if on_x86.needed.source in {"opened", "opened by Python"}:
        return f"the code opens {on_x86.needed.what}, which is compiled for amd64 only", on_x86.needed
    if on_x86.needed.source == "started":
        return f"the code starts {on_x86.needed.what}, which is compiled for amd64 only", on_x86.needed
    what = (
        f"it includes {on_x86.needed.what}" if on_x86.needed.source == "header" else f"{on_x86.needed.what} is passed"
    )
    return f"{what}, which only x86 has, on every processor", on_x86.needed


def _of_base(base_image: str, ros_distro: str | None) -> Against | None:
    if beginning := next((name for name in amd64_only("image") if base_image.startswith(name)), None):
        return f"{beginning.rstrip('/')} is published for amd64 only", None
    release = distro(ros_distro)
    if release is not None and not release.arm64:
        return f"ROS {release.name} was never built for arm64", None
    return None


def _of_cuda(kind: Kind, base_image: str, cuda: str | None, python: Python) -> Against | None:
    number = cuda or CUDA
    if base_image.startswith("nvidia/cuda") and Version(number) < arm64_since("cuda image"):
        return f"nvidia/cuda has no arm64 image of CUDA {number} for this Ubuntu", None
    if kind == "cuda" and python.manager != "system" and Version(number) < arm64_since("cuda wheels"):
        return f"frameworks have no arm64 wheels for CUDA {number}", None
    return None


def _of_toolkit(apt: Iterable[str], ubuntu: str | None) -> Against | None:
    """Tell of Ubuntu's own toolkit of CUDA, without which nothing is compiled for it."""
    if TOOLKIT in apt and ubuntu not in toolkits_for_arm64():
        return f"Ubuntu {ubuntu} has {TOOLKIT} for amd64 only", None
    return None


def _of_wheels(python: Python, installed: tuple[Requirement, ...]) -> Against | None:
    on_arm64 = python.interpreter.on(ARM64)
    below = {bound.key: bound.below for bound in python.bounds}
    for asked in installed:
        guessed = asked in python.pip_guessed and asked.key not in accelerated()  # without a framework nothing runs
        if guessed or not on_arm64.may(asked):
            continue  # a guess that cannot be installed is reported, but does not fail the build
        if asked.wheel and asked.wheel.amd64_only:
            return f"{asked.key} is a wheel for amd64", asked
        if asked.key not in arm64_wheels():
            continue
        first = arm64_wheels()[asked.key]
        if first is None:
            return f"{asked.key} has no arm64 wheels", asked
        release = version_of(asked.release) if asked.release else None
        if release and release < first:
            return f"{asked.key} has arm64 wheels from {first} on, but {asked.release} is pinned", asked
        if (bound := below.get(asked.key)) and Version(bound) <= first:
            return f"{asked.key} has arm64 wheels from {first} on, but one before {bound} is needed", asked
    return None


def _of_conda(evidence: Evidence, python: Python) -> Against | None:
    for environment in evidence.conda:
        if environment.file == python.conda_file:
            for package in environment.packages:
                if package.build:
                    return f"{package.written} names a build for one platform", environment
                if package.name in amd64_only("conda"):
                    return f"conda has no arm64 package for {package.written}", environment
    names = {spec.partition("=")[0] for spec in python.conda_specs if not python.conda_file}
    if lacking := next((name for name in amd64_only("conda") if name in names), None):
        return f"conda has no arm64 package for {lacking}", None
    number = version_of(python.version or "")
    if python.manager == "conda" and number and number < arm64_since("conda python"):
        return f"conda-forge has no arm64 build of Python {python.version}", None
    return None
