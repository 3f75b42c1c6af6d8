"""Bases of the author's own Dockerfile that no longer answer, and what its build starts from in their place."""

from __future__ import annotations

from roslab.decide.decision import MendedBase
from roslab.evidence.facts import AuthorDockerfile
from roslab.knowledge.distros import Distro, distro, ubuntus
from roslab.knowledge.frameworks import cuda_image, nearest_cuda_image
from roslab.knowledge.os_releases import ends, has_ended, release_of
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

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


def mended(name: str, authored: AuthorDockerfile) -> MendedBase | None:
    """Return what replaces an image of a Dockerfile, ``None`` where it answers, or its name is not known."""
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
    from roslab.knowledge.ended_bases import ended  # noqa: PLC0415 - most trees have no Dockerfile

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
