"""The base image and its Ubuntu."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

from roslab.config.model import Config, Kind
from roslab.decide.cuda.version import Cuda
from roslab.decide.decision import Choice, Reason
from roslab.decide.python.base import base_for
from roslab.decide.reasons import because, configured, ranked, strongest
from roslab.decide.system.cmake_version import has_it, needed_cmake
from roslab.evidence.facts import AuthorDockerfile, Dependency, Evidence
from roslab.knowledge.distros import Distro, distros, ubuntus, variants

DEFAULT_UBUNTU = "jammy"
"""Of plain C++ where nothing is said: old enough for yesterday's code, new enough for today's."""
_NVIDIA = ("nvidia/", "nvcr.io/")
_ROOTS = (*_NVIDIA, "ros:", "osrf/ros:", "ubuntu:", "debian:", "python:")


class Weight:
    """What speaks for a base or its Ubuntu."""

    BUILT = 800  # the author's Dockerfile is built as it is: nothing of ours comes before its FROM
    AUTHORS_IMAGE = 700  # it ran there
    SAID: ClassVar = {"ci": 400, "readme": 300, "script": 200}
    SAID_ELSEWHERE = 100
    NEW_ENOUGH = 50  # for the CMake that the build asks for: what the author names goes before it, CMake comes from pip
    DEFAULT = 1


@dataclass(frozen=True, kw_only=True, slots=True)
class BaseImage:
    """The FROM, its Ubuntu codename (``None`` on Debian or unknown), and ROS packages that the image lacks."""

    image: str
    ubuntu: str | None
    ros_packages: tuple[str, ...] = ()
    """apt names of the ROS variant that must be installed on top (``ros-noetic-desktop-full``)."""


def decide_base(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    chosen: Choice[Distro | None],
    cuda: Cuda,
    python: str | None,
) -> Choice[BaseImage]:
    """Return the image to start from."""
    base = config.base
    if base.image:
        said = configured(config, "base_image", base.image, "base.image")
        ubuntu = base.ubuntu or _codename(base.image)
        return Choice(answer=BaseImage(image=base.image, ubuntu=ubuntu), reasons=(said,))
    if chosen.answer:
        return _ros(evidence, config, chosen.answer, chosen.reasons[0], cuda)
    if kind == "cpp" and not cuda.version:
        return _cpp(evidence, config)
    python = None if kind == "cpp" else python  # C++ starts from an Ubuntu for its own sake
    image, ubuntu, reasons = base_for(kind, cuda.version, cuda.cudnn if cuda.cudnn_named else None, base.ubuntu, python)
    return Choice(answer=BaseImage(image=image, ubuntu=ubuntu), reasons=reasons)


def of_dockerfile(
    choice: Choice[BaseImage], evidence: Evidence, config: Config, dockerfile: str | None
) -> Choice[BaseImage]:
    """Return the FROM of the author's own Dockerfile where that is built, with all that spoke for another base."""
    authored = next((r for r in evidence.dockerfiles if r.file == dockerfile and r.base and "$" not in r.base), None)
    if authored is None or authored.base is None or config.base.image:
        return choice
    said = "the author's Dockerfile starts from it"
    why = because("base_image", authored.base, said, authored, weight=Weight.BUILT)
    others = (replace(r, decisive=r.question != "base_image" and r.decisive) for r in choice.reasons)
    answer = replace(choice.answer, image=authored.base, ubuntu=_codename(authored.base) or choice.answer.ubuntu)
    return replace(choice, answer=answer, reasons=(why, *others))


def _ros(evidence: Evidence, config: Config, distro: Distro, why: Reason, cuda: Cuda) -> Choice[BaseImage]:
    variant = config.base.ros.partition("-")[2] if config.base.ros else ""
    on_top = (f"ros-{distro.name}-{variant}",) if variants().get(variant) is False else ()
    authored = _nvidia_dockerfile(evidence)
    if cuda.version and (config.base.cuda or authored):
        image, _, reasons = base_for(
            "cuda", cuda.version, cuda.cudnn if cuda.cudnn_named else None, distro.ubuntu, None
        )
        if config.base.cuda or authored is None:
            said = configured(config, "base_image", image, "base.cuda")
        else:
            said = because(
                "base_image",
                image,
                f"the author's image is FROM {authored.base}",
                authored,
                weight=Weight.AUTHORS_IMAGE,
            )
        packages = on_top or (f"ros-{distro.name}-{variant or 'ros-base'}",)
        answer = BaseImage(image=image, ubuntu=distro.ubuntu, ros_packages=packages)
        return Choice(answer=answer, reasons=(said, *reasons))
    image = f"ros:{distro.name}-{variant if variants().get(variant) else 'ros-base'}"
    reasons = (
        replace(why, question="base_image", answer=image, reason=f"the official image of ROS {distro.name}"),
        replace(why, question="ubuntu", answer=distro.ubuntu, reason=f"the Ubuntu of ROS {distro.name}"),
    )
    return Choice(answer=BaseImage(image=image, ubuntu=distro.ubuntu, ros_packages=on_top), reasons=reasons)


def _nvidia_dockerfile(evidence: Evidence) -> AuthorDockerfile | None:
    """Return the project's own image where it is on CUDA: the plainest Dockerfile nearest to the root.

    An image of the author's own making (``lab/robot:base``) says nothing: another Dockerfile builds it.
    """
    own = [
        authored
        for authored in evidence.dockerfiles
        if authored.purpose == "project" and (authored.base or "").startswith(_ROOTS)
    ]
    own.sort(
        key=lambda authored: (
            authored.file.count("/"),
            authored.file.rpartition("/")[2].lower() != "dockerfile",
            authored.file,
        )
    )
    return own[0] if own and (own[0].base or "").startswith(_NVIDIA) else None


def _cpp(evidence: Evidence, config: Config) -> Choice[BaseImage]:
    reasons = [because("ubuntu", DEFAULT_UBUNTU, "nothing is said: the default", weight=Weight.DEFAULT)]
    if config.base.ubuntu:
        reasons.append(configured(config, "ubuntu", config.base.ubuntu, "base.ubuntu"))
    for authored in evidence.dockerfiles:
        codename = _codename(authored.base or "")
        if codename and authored.purpose in {"project", "ci"}:
            why = f"the author's image is FROM {authored.base}"
            reasons.append(because("ubuntu", codename, why, authored, weight=Weight.AUTHORS_IMAGE))
    for mention in evidence.mentions:
        codename = ubuntus().get(mention.value, mention.value)
        if mention.topic == "ubuntu" and codename in ubuntus().values():
            weight = Weight.SAID.get(mention.source, Weight.SAID_ELSEWHERE)
            reasons.append(because("ubuntu", codename, mention.text[:120], mention, weight=weight))
    reasons = _new_enough(reasons, needed_cmake(evidence))
    best = strongest(reasons)
    version = next(number for number, codename in ubuntus().items() if codename == best.answer)
    image = f"ubuntu:{version}"
    base = replace(best, question="base_image", answer=image, reason=f"plain C++ on Ubuntu {version}")
    return Choice(answer=BaseImage(image=image, ubuntu=best.answer), reasons=(base, *ranked(reasons, best.answer)))


def _new_enough(reasons: list[Reason], demand: Dependency | None) -> list[Reason]:
    """Offer the oldest Ubuntu from the default on whose own CMake will do, where the default's is too old.

    What the author names goes before it: CMake can come from pip there.
    """
    if has_it(DEFAULT_UBUNTU, demand):
        return reasons
    releases = list(ubuntus().values())
    later = releases[releases.index(DEFAULT_UBUNTU) :]
    fitting = next((codename for codename in later if has_it(codename, demand)), None)
    if demand is None or fitting is None:
        return reasons
    why = f"the build asks for CMake {demand.version}"
    return [*reasons, because("ubuntu", fitting, why, demand, weight=Weight.NEW_ENOUGH)]


def _codename(image: str) -> str | None:
    """Return the Ubuntu of an image's name: ``nvidia/cuda:…-ubuntu20.04``, ``ubuntu:focal``, ``ros:noetic``."""
    for version, codename in ubuntus().items():
        if codename in image or f"ubuntu{version}" in image or f"ubuntu:{version}" in image:
            return codename
    for name, found in distros().items():
        if f":{name}" in image or f"-{name}" in image:
            return found.ubuntu
    return None
