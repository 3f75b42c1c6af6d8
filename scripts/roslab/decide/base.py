"""The base image and its Ubuntu."""

from __future__ import annotations

from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.cuda import CudaChoice
from roslab.decide.decision import Reason
from roslab.decide.distro import DistroChoice
from roslab.decide.python_base import base_for
from roslab.decide.reasons import configured
from roslab.evidence.facts import Evidence, Mention, Recipe
from roslab.knowledge.distros import distros, ubuntus

DEFAULT_UBUNTU = "jammy"
"""Of plain C++ where nothing is said: old enough for yesterday's code, new enough for today's."""
_NVIDIA = ("nvidia/", "nvcr.io/")
_ROOTS = (*_NVIDIA, "ros:", "osrf/ros:", "ubuntu:", "debian:", "python:")
_DESKTOPS = ("desktop-full", "desktop", "simulation", "perception", "robot")


@dataclass(frozen=True, kw_only=True, slots=True)
class BaseChoice:
    """The FROM, its Ubuntu codename (``None`` on Debian or unknown), and ROS packages that the image lacks."""

    image: str
    ubuntu: str | None
    ros_packages: tuple[str, ...] = ()
    """apt names of the ROS variant that must be installed on top (``ros-noetic-desktop-full``)."""
    reasons: tuple[Reason, ...] = ()


def decide_base(evidence: Evidence, config: Config, kind: Kind, chosen: DistroChoice, cuda: CudaChoice, python: str | None) -> BaseChoice:
    """Return the image to start from."""
    base = config.base
    if base.image:
        return BaseChoice(image=base.image, ubuntu=base.ubuntu or _codename(base.image), reasons=(configured(config, "base_image", base.image, "base.image"),))
    if chosen.distro:
        return _ros(evidence, config, chosen, cuda)
    if kind == "cpp" and not cuda.cuda:
        return _cpp(evidence, config)
    image, ubuntu, reasons = base_for(kind, cuda.cuda, cuda.cudnn, base.ubuntu, python)
    return BaseChoice(image=image, ubuntu=ubuntu, reasons=reasons)


def _ros(evidence: Evidence, config: Config, chosen: DistroChoice, cuda: CudaChoice) -> BaseChoice:
    found = chosen.distro
    assert found is not None  # noqa: S101 - the caller asked only where there is one
    variant = config.base.ros.partition("-")[2] if config.base.ros else ""
    desktop = (f"ros-{found.name}-{variant}",) if variant in _DESKTOPS and variant not in {"perception", "robot"} else ()
    why = chosen.reasons[0]
    recipe = _nvidia_recipe(evidence)
    if cuda.cuda and (config.base.cuda or recipe):
        image, _, reasons = base_for("cuda", cuda.cuda, cuda.cudnn, found.ubuntu, None)
        if config.base.cuda:
            more = configured(config, "base_image", image, "base.cuda")
        else:
            assert recipe is not None  # noqa: S101
            more = Reason(question="base_image", answer=image, reason=f"the author's image is FROM {recipe.base}", file=recipe.file, line=recipe.base_line, weight=700)
        return BaseChoice(image=image, ubuntu=found.ubuntu, ros_packages=desktop or (f"ros-{found.name}-{variant or 'ros-base'}",), reasons=(more, *reasons))
    official = variant if variant in {"ros-core", "ros-base"} else "ros-base"
    image = f"ros:{found.name}-{official}"
    reason = Reason(question="base_image", answer=image, reason=f"the official image of ROS {found.name}", file=why.file, line=why.line, weight=why.weight)
    ubuntu = Reason(question="ubuntu", answer=found.ubuntu, reason=f"the Ubuntu of ROS {found.name}", file=why.file, line=why.line, weight=why.weight)
    more_packages = (f"ros-{found.name}-{variant}",) if variant in {"perception", "robot"} else desktop
    return BaseChoice(image=image, ubuntu=found.ubuntu, ros_packages=more_packages, reasons=(reason, ubuntu))


def _nvidia_recipe(evidence: Evidence) -> Recipe | None:
    """Return the project's own image where it is on CUDA: the plainest Dockerfile nearest to the root.

    An image of the author's own making (``lab/robot:base``) says nothing: another recipe builds it.
    """
    own = [recipe for recipe in evidence.recipes if recipe.purpose == "project" and (recipe.base or "").startswith(_ROOTS)]
    own.sort(key=lambda recipe: (recipe.file.count("/"), recipe.file.rpartition("/")[2].lower() != "dockerfile", recipe.file))
    return own[0] if own and (own[0].base or "").startswith(_NVIDIA) else None


def _cpp(evidence: Evidence, config: Config) -> BaseChoice:
    reasons: list[Reason] = []
    if config.base.ubuntu:
        reasons.append(configured(config, "ubuntu", config.base.ubuntu, "base.ubuntu"))
    for recipe in evidence.recipes:
        codename = _codename(recipe.base or "")
        if codename and recipe.purpose in {"project", "ci"}:
            reasons.append(Reason(question="ubuntu", answer=codename, reason=f"the author's image is FROM {recipe.base}", file=recipe.file, line=recipe.base_line, weight=700))
    for mention in evidence.mentions:
        if mention.topic == "ubuntu" and (reason := _ubuntu(mention)):
            reasons.append(reason)
    if not reasons:
        reasons.append(Reason(question="ubuntu", answer=DEFAULT_UBUNTU, reason="nothing is said: the default", weight=1))
    best = max(reasons, key=lambda reason: reason.weight)
    version = next(number for number, codename in ubuntus().items() if codename == best.answer)
    image = f"ubuntu:{version}"
    base = Reason(question="base_image", answer=image, reason=f"plain C++ on Ubuntu {version}", file=best.file, line=best.line, weight=best.weight)
    return BaseChoice(image=image, ubuntu=best.answer, reasons=(base, best))


def _ubuntu(mention: Mention) -> Reason | None:
    codename = ubuntus().get(mention.value, mention.value)
    if codename not in ubuntus().values():
        return None
    weight = {"ci": 400, "readme": 300, "script": 200}.get(mention.source, 100)
    return Reason(question="ubuntu", answer=codename, reason=mention.text[:120], file=mention.file, line=mention.line, weight=weight)


def _codename(image: str) -> str | None:
    """Return the Ubuntu of an image's name: ``nvidia/cuda:…-ubuntu20.04``, ``ubuntu:focal``, ``ros:noetic``."""
    for version, codename in ubuntus().items():
        if codename in image or f"ubuntu{version}" in image or f"ubuntu:{version}" in image:
            return codename
    for name, found in distros().items():
        if f":{name}" in image or f"-{name}" in image:
            return found.ubuntu
    return None
