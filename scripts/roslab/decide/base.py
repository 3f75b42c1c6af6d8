"""The base image and its Ubuntu."""

from __future__ import annotations

from typing import ClassVar

from roslab.config.model import Config, Kind
from roslab.decide.cuda.toolkit import Toolkit
from roslab.decide.cuda.version import Cuda
from roslab.decide.day import existed
from roslab.decide.decision import Choice, MendedBase, Reason
from roslab.decide.equal_ubuntus import best_of_equals
from roslab.decide.python.base import base_for, cuda_ubuntus
from roslab.decide.reasons import CONFIGURED, because, configured, ranked, strongest
from roslab.decide.ros.distro_dates import ADOPTED, dated, later
from roslab.decide.ros.lower_bounds import bounds
from roslab.decide.system.cmake_version import has_it, needed_cmake
from roslab.decide.system.code_fits import misfits
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import AuthorDockerfile, Evidence, Mention
from roslab.knowledge.distros import Distro, codename_of, ubuntu_released, ubuntus, variants
from roslab.values.dataclass import dataclass, replace

OLDEST_BY_DATE = "xenial"
"""No older Ubuntu is chosen by a date alone: code for an older one still compiles on it."""
DEFAULT_UBUNTU = "jammy"
"""The Ubuntu of plain C++ when nothing names one: old enough for older code, new enough for today's."""
_NVIDIA = ("nvidia/", "nvcr.io/")
_NO_CUDA = ("nvidia/opengl", "nvidia/vulkan", "nvcr.io/nvidia/opengl", "nvcr.io/nvidia/vulkan")
"""Images of NVIDIA's for drawing alone. https://gitlab.com/nvidia/container-images/opengl, 2026-11-27"""
_ROOTS = (*_NVIDIA, "ros:", "osrf/ros:", "ubuntu:", "debian:", "python:")


class Weight:
    """How much each reason for a base or its Ubuntu counts."""

    BUILT = 800  # the author's Dockerfile is built unchanged, from its own FROM
    AUTHORS_IMAGE = 700  # the code ran on it
    SAID: ClassVar = {"ci": 400, "readme": 300, "script": 200}
    SAID_ELSEWHERE = 100
    LISTED = 60  # has the release of a library that a page lists, where no Ubuntu is named
    NEW_ENOUGH = 50  # has the CMake that the build asks for; what the author names wins: CMake can come from pip
    DATE = 2  # the last commit's time, where nothing else is known
    DEFAULT = 1
    DOES_NOT_COMPILE = 400  # subtracted: a page may be older than the code


@dataclass(frozen=True, kw_only=True, slots=True)
class BaseImage:
    """The FROM, its Ubuntu codename (``None`` on Debian or unknown), and the ROS packages to install on it."""

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
    toolkit: Toolkit = "devel",
) -> Choice[BaseImage]:
    """Return the image to start from; ``toolkit`` is how much of CUDA the packages need."""
    base = config.base
    if base.image:
        said = configured(config, "base_image", base.image, "base.image")
        ubuntu = base.ubuntu or codename_of(base.image)
        return Choice(answer=BaseImage(image=base.image, ubuntu=ubuntu), reasons=(said,))
    if chosen.answer:
        why = next((each for each in chosen.reasons if each.answer == chosen.answer.name), chosen.reasons[0])
        return _ros(evidence, config, chosen.answer, why, cuda)
    if kind == "cpp" and not base.cuda:  # of CUDA's version a page may speak, for those who want it
        return _cpp(evidence, config)
    python = None if kind == "cpp" else python  # for C++ the Ubuntu is chosen without regard to Python
    cudnn = cuda.cudnn if cuda.cudnn_named else None
    toolkit = "devel" if base.cuda else toolkit
    named = named_ubuntus(evidence, config) if kind == "cuda" and python is None and not base.ubuntu else ()
    having = cuda_ubuntus(cuda.version)
    best = next((reason for reason in named if reason.answer in having), None)
    asked = best.answer if best else base.ubuntu
    lacking = misfits(evidence) if kind == "cuda" and python is None else {}
    image, ubuntu, reasons = base_for(kind, cuda.version, cudnn, asked, python, toolkit=toolkit, lacking=lacking)
    reasons = (*reasons, best) if best and best.answer == ubuntu else reasons
    return Choice(answer=BaseImage(image=image, ubuntu=ubuntu), reasons=reasons)


def of_dockerfile(
    choice: Choice[BaseImage],
    evidence: Evidence,
    config: Config,
    dockerfile: str | None,
    mended: tuple[MendedBase, ...],
) -> Choice[BaseImage]:
    """Return what the author's own Dockerfile starts from if that is built, with the reasons for other bases."""
    authored = next((r for r in evidence.dockerfiles if r.file == dockerfile and r.base and "$" not in r.base), None)
    if authored is None or authored.base is None or config.base.image:
        return choice
    taken = next((base.image for base in mended if base.name == authored.base), authored.base)
    said = "the author's Dockerfile starts from it"
    if taken != authored.base:
        said = f"in place of {authored.base}, from which the author's Dockerfile starts"
    why = because("base_image", taken, said, authored, weight=Weight.BUILT)
    others = (replace(r, decisive=r.question != "base_image" and r.decisive) for r in choice.reasons)
    answer = replace(choice.answer, image=taken, ubuntu=codename_of(taken) or choice.answer.ubuntu)
    return replace(choice, answer=answer, reasons=(why, *others))


def _ros(evidence: Evidence, config: Config, distro: Distro, why: Reason, cuda: Cuda) -> Choice[BaseImage]:
    variant = config.base.ros.partition("-")[2] if config.base.ros else ""
    on_top = (f"ros-{distro.name}-{variant}",) if variants().get(variant) is False else ()
    authored = nvidia_dockerfile(evidence)
    if cuda.version and (config.base.cuda or authored or cuda.compiled):
        image, _, reasons = base_for(
            "cuda", cuda.version, cuda.cudnn if cuda.cudnn_named else None, distro.ubuntu, None
        )
        if cuda.compiled:
            said = because("base_image", image, "packages are compiled for CUDA", weight=Weight.AUTHORS_IMAGE)
        elif config.base.cuda or authored is None:
            said = configured(config, "base_image", image, "base.cuda")
        else:
            said = because(
                "base_image",
                image,
                f"the author's image starts from {authored.base}",
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


def nvidia_dockerfile(evidence: Evidence) -> AuthorDockerfile | None:
    """Return the project's Dockerfile that starts from CUDA: the plainest one, nearest to the root.

    A base that the author built (``lab/robot:base``) tells nothing: another Dockerfile makes it.
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
            _has_cuda(authored),  # beside one without CUDA, it is for those who want it
            authored.file,
        )
    )
    return own[0] if own and _has_cuda(own[0]) else None


def _has_cuda(authored: AuthorDockerfile) -> bool:
    base = authored.base or ""
    return base.startswith(_NVIDIA) and not base.startswith(_NO_CUDA)


def _cpp(evidence: Evidence, config: Config) -> Choice[BaseImage]:
    from roslab.decide.listed_releases import of_listed_releases  # noqa: PLC0415 - few trees list releases

    reasons = [_by_packages(evidence, _by_date(evidence))]
    if config.base.ubuntu:
        reasons.append(configured(config, "ubuntu", config.base.ubuntu, "base.ubuntu"))
    for authored in evidence.dockerfiles:
        codename = codename_of(authored.base or "")
        if codename and authored.purpose in {"project", "ci"}:
            why = f"the author's image starts from {authored.base}"
            reasons.append(because("ubuntu", codename, why, authored, weight=Weight.AUTHORS_IMAGE))
    reasons += _said(evidence, reasons)
    lacking, demand = misfits(evidence), needed_cmake(evidence)
    reasons = [_compiling(reason, lacking) for reason in reasons]
    reasons = _fitting(_new_enough(reasons, demand, lacking), lacking)
    best = strongest(reasons)
    if best.weight < Weight.LISTED:
        weight = Weight.LISTED
        reasons += of_listed_releases(
            evidence, best.answer, _usual_first(), lacking=lacking, demand=demand, weight=weight
        )
    reasons = [each for each in reasons if each.weight >= CONFIGURED or existed(evidence, each.answer)]
    best = best_of_equals(reasons, evidence, demand, ci=Weight.SAID["ci"], below=Weight.AUTHORS_IMAGE)
    version = next(number for number, codename in ubuntus().items() if codename == best.answer)
    image = f"ubuntu:{version}"
    base = replace(best, question="base_image", answer=image, reason=f"plain C++ on Ubuntu {version}")
    return Choice(answer=BaseImage(image=image, ubuntu=best.answer), reasons=(base, *ranked(reasons, best.answer)))


def _said(evidence: Evidence, known: list[Reason]) -> list[Reason]:
    """Return the Ubuntus that are mentioned; ``known``: that of the last commit's time, then those of other reasons.

    The oldest one on which the code works gives way to that of its time, unless a later one is named as well.
    """
    said = [m for m in evidence.mentions if m.topic == "ubuntu" and _release(m) in ubuntus().values()]
    released = ubuntu_released()
    firm = [_release(m) for m in said if not bounds(m)] + [reason.answer for reason in known[1:]]
    reasons = []
    for mention in said:
        codename, text = _release(mention), mention.text[:120]
        if bounds(mention):
            if any(released[name] >= released[codename] for name in firm):
                continue
            codename = max(codename, known[0].answer, key=lambda name: released[name])
            text += f": {codename} is of the last commit's time" if codename == known[0].answer else ""
        weight = Weight.SAID.get(mention.source, Weight.SAID_ELSEWHERE)
        reasons.append(because("ubuntu", codename, text, mention, weight=weight))
    return reasons


def _release(mention: Mention) -> str:
    return ubuntus().get(mention.value, mention.value)


def named_ubuntus(evidence: Evidence, config: Config) -> tuple[Reason, ...]:
    """Return the Ubuntus that the author names for code that is only compiled, where it compiles, strongest first."""
    said = [each for each in _cpp(evidence, config).reasons if each.question == "ubuntu"]
    return tuple(sorted((r for r in said if r.weight >= Weight.SAID_ELSEWHERE), key=lambda reason: -reason.weight))


def _by_date(evidence: Evidence) -> Reason:
    """Return the default Ubuntu, or an older one that code of its last commit's time was written for."""
    date = dated(evidence)
    released = ubuntu_released()
    if date is None or date.value >= later(released[DEFAULT_UBUNTU], ADOPTED):
        return because("ubuntu", DEFAULT_UBUNTU, "no Ubuntu is named: the default", weight=Weight.DEFAULT)
    adopted = [name for name, day in released.items() if later(day, ADOPTED) <= date.value]
    answer = max((OLDEST_BY_DATE, *adopted), key=lambda name: released[name])
    return because(
        "ubuntu", answer, f"no Ubuntu is named; the last commit is of {date.value}", date, weight=Weight.DATE
    )


def _by_packages(evidence: Evidence, dated_: Reason) -> Reason:
    """Return an older Ubuntu than that of the last commit's time, if pages and scripts install what only it has."""
    from roslab.decide.system.old_packages import with_old_packages  # noqa: PLC0415 - few trees are only compiled

    if (found := with_old_packages(evidence, dated_.answer)) is None:
        return dated_
    older, package = found
    why = f"no Ubuntu is named; it has {package.name}, which {dated_.answer} does not have"
    return because("ubuntu", older, why, package, weight=Weight.DATE)


def _compiling(reason: Reason, lacking: dict[str, tuple[str, ...]]) -> Reason:
    """Lower the weight of an Ubuntu whose compiler or libraries the code does not compile with."""
    missing = lacking.get(reason.answer, ())
    if not missing or reason.weight >= Weight.AUTHORS_IMAGE:
        return reason
    text = f"{reason.reason}; but {reason.answer} comes without {missing[0]}"
    return replace(reason, reason=text, weight=max(Weight.DEFAULT - 1, reason.weight - Weight.DOES_NOT_COMPILE))


def _fitting(reasons: list[Reason], lacking: dict[str, tuple[str, ...]]) -> list[Reason]:
    """Add the default Ubuntu, else the newest older one, else the oldest newer one, that the code compiles on."""
    if not any(lacking.get(reason.answer) for reason in reasons):
        return reasons
    fitting = next((name for name in _usual_first() if not lacking.get(name)), None)
    if fitting is None:
        return reasons
    return [*reasons, because("ubuntu", fitting, "the code compiles with its libraries", weight=Weight.NEW_ENOUGH)]


def _usual_first() -> tuple[str, ...]:
    """Return the default Ubuntu, the older ones from the newest on, and the newer ones from the oldest on."""
    names = list(ubuntus().values())
    default = names.index(DEFAULT_UBUNTU)
    return (*reversed(names[: default + 1]), *names[default + 1 :])


def _new_enough(reasons: list[Reason], demand: Dependency | None, lacking: dict[str, tuple[str, ...]]) -> list[Reason]:
    """Add the oldest later Ubuntu with the CMake of the build, if that of the last commit's time, the first, has none.

    An Ubuntu that the author names wins over it: there CMake can come from pip.
    """
    usual = reasons[0].answer
    if has_it(usual, demand):
        return reasons
    releases = list(ubuntus().values())
    later = releases[releases.index(usual) :]
    fitting = next((codename for codename in later if has_it(codename, demand) and not lacking.get(codename)), None)
    if demand is None or fitting is None:
        return reasons
    asks = "the build asks for" if demand.name == "CMake" else f"{demand.name} is called, which needs"
    why = f"{asks} CMake {demand.version}"
    return [*reasons, because("ubuntu", fitting, why, demand, weight=Weight.NEW_ENOUGH)]
