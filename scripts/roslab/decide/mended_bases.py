"""Bases of the author's own Dockerfile that no longer answer, and what its build starts from in their place."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.chains import local
from roslab.decide.decision import Choice, MendedBase, Reason
from roslab.decide.reasons import because
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.distros import Distro, distro, ubuntus
from roslab.knowledge.ended_bases import ended
from roslab.knowledge.frameworks import cuda_image, nearest_cuda_image
from roslab.knowledge.os_releases import ends, has_ended, release_of
from roslab.values.dataclass import dataclass
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_WEIGHT = 900
"""Above that of the FROM itself: it is what the build starts from."""
_CUDA = pattern(
    r"(?P<where>(?:docker\.io/|nvcr\.io/)?)nvidia/cuda(?P<gl>gl)?:(?P<cuda>\d+\.\d+)(?P<patch>\.\d+)?"
    r"(?:-(?P<cudnn>cudnn\d*))?-(?P<flavour>base|runtime|devel)-ubuntu(?P<ubuntu>\d\d\.\d\d)"
)
_ROS = pattern(r"(?:^|/)ros:([a-z]+)")


@dataclass(frozen=True, kw_only=True, slots=True)
class Nearest:
    """An image in the place of one that is gone."""

    image: str
    why: str


def decide_bases(evidence: Evidence, config: Config, dockerfile: str | None) -> Choice[tuple[MendedBase, ...]]:
    """Return the bases to replace in the author's Dockerfile; ``repair: false`` leaves those that are built first."""
    authored = next((each for each in evidence.dockerfiles if each.file == dockerfile), None)
    if authored is None:
        return Choice(answer=())
    found = [
        (base, line)
        for name, line in dict(authored.bases).items()
        if (base := _local(name, authored, evidence) or (None if config.repair is False else _mended(name, authored)))
    ]
    return Choice(answer=tuple(base for base, _ in found), reasons=tuple(_reason(authored, *each) for each in found))


def _reason(authored: AuthorDockerfile, base: MendedBase, line: int) -> Reason:
    replaced = f"; the build replaces {base.name} and changes no line of the Dockerfile"
    text = base.why + (replaced if base.recipe is None else ", and so does the build here")
    place = Place(file=authored.file, line=line)
    return because("mended_base", base.image, text, place, weight=_WEIGHT)


def _local(name: str, authored: AuthorDockerfile, evidence: Evidence) -> MendedBase | None:
    first = local(name, authored, evidence)
    if first is None or first.problem or first.dockerfile is None or first.dockerfile.base is None:
        return None
    why = f"line {first.said.line} of {first.said.file} builds it first, from {first.dockerfile.file}"
    return MendedBase(name=name, image=first.dockerfile.base, why=why, recipe=first.dockerfile.recipe)


def _mended(name: str, authored: AuthorDockerfile) -> MendedBase | None:
    if "$" in name:
        return None
    if near := nearest(name):
        return MendedBase(name=name, image=near.image, why=near.why)
    release = distro_of(name)
    if release and release.rosdistro_tag:
        why = f"ROS {release.name} ended on {release.eol}: its keys expired and its packages moved"
        if authored.updates_rosdep:
            why += f"; the `rosdep update` of line {authored.updates_rosdep} would skip it"
        return MendedBase(name=name, image=name, why=why)
    codename = release_of(name)
    if codename and has_ended(codename):
        return MendedBase(
            name=name, image=name, why=f"{codename} ended on {ends()[codename]}: its packages may have moved"
        )
    return None


def distro_of(image: str) -> Distro | None:
    """Return the distribution of an image of ROS, by its name."""
    found = _ROS.search(image)
    return distro(found[1]) if found else None


def nearest(image: str) -> Nearest | None:
    """Return the image to take in place of one that is gone, ``None`` where it is there or nothing is near it.

    Of CUDA: the last patch release, else the oldest newer CUDA with images; the flavour and the Ubuntu stay where
    there are images of them.
    """
    match = _CUDA.fullmatch(image)
    if match is None:
        return None
    row = cuda_image(match["cuda"])
    there = bool(row and row.tag)
    if there and row and not match["gl"] and match["patch"] and match["cuda"] + match["patch"] == row.tag:
        return None
    taken = row if row and row.tag else nearest_cuda_image(match["cuda"])
    ubuntu = _ubuntu(match["ubuntu"], taken.ubuntu)
    cudnn = f"{taken.cudnn}-" if match["cudnn"] else ""
    name = f"{match['where']}nvidia/cuda:{taken.tag}-{cudnn}{match['flavour']}-ubuntu{ubuntu}"
    asked = match["cuda"] + (match["patch"] or "")
    step = f"the last patch of CUDA {taken.cuda}" if there else f"CUDA {taken.cuda} is the nearest that has images"
    return Nearest(image=name, why=f"{ended(image) or f'CUDA {asked} was deleted from the registry'}; {step}")


def _ubuntu(version: str, among: tuple[str, ...]) -> str:
    """Return the version of the same Ubuntu, else of the nearest newer one, else of the newest that has images."""
    having = [number for number, codename in ubuntus().items() if codename in among]
    return next((number for number in having if number >= version), having[-1])
