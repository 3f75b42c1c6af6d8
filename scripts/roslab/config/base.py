"""What the image starts from, read from the keys of each format."""

from __future__ import annotations

from typing import Literal, cast

from roslab.config import vocabulary
from roslab.config.model import Base, Generation
from roslab.config.node import Mapping, Node, Scalar
from roslab.config.reading import Reading, Text
from roslab.knowledge.distros import releases_of

Flavour = Literal["base", "runtime", "devel"]


def base(reading: Reading, root: Mapping, generation: Generation) -> Base:
    """Read ``base``, or ``distro`` and ``runtime`` of the paper's format."""
    if generation == "paper":
        return _paper(reading, root)
    mapping = reading.mapping(root, "base")
    reading.note("base", root.key("base"))
    ubuntu = _ubuntu(reading, reading.text(mapping, "version" if generation == "interim" else "ubuntu", "base.ubuntu"))
    ros = reading.text(mapping, "ros", "base.ros")
    _agree(reading, ubuntu, ros, mapping)
    cuda, flavour = _cuda(reading, mapping, generation)
    cudnn, cudnn_flavour = _split(reading.text(mapping, "cudnn", "base.cudnn"))
    if cudnn_flavour and cuda and flavour != cudnn_flavour:
        if flavour is not None:
            node = mapping.get("cudnn") if mapping else None
            reading.warn("cuda and cudnn ask for different flavours: an image has one, devel holds both", node)
        flavour = "devel" if "devel" in {flavour, cudnn_flavour} else cudnn_flavour
    opengl = cast(Literal["runtime", "devel"] | None, reading.value(mapping, "opengl", "base.opengl"))
    if generation == "interim" and cuda and not cudnn and not opengl:
        cudnn = "7"  # its images with CUDA alone were nvidia/cuda:…-cudnn7-devel
    return Base(
        image=reading.value(mapping, "image", "base.image"),
        ubuntu=ubuntu,
        ros=ros.value if ros else None,
        cuda=cuda,
        cuda_flavour=flavour,
        cudnn=cudnn,
        opengl=opengl,
        python=reading.value(mapping, "python", "base.python"),
        icub=_icub(reading, mapping),
        cmake_update=reading.value(mapping, "cmake_update", "base.cmake_update"),
    )


def implied(reading: Reading, root: Mapping, generation: Generation, found: Base) -> bool | None:
    """Return whether the format's run script shared display and GPU, ``None`` if the format does not determine it."""
    if generation == "today" or not (found.opengl or found.cuda):
        return None
    mapping = reading.mapping(root, "base")
    where: Node | None = root.get("runtime")
    if mapping is not None:
        where = mapping.key("opengl") or mapping.key("cuda")
    reading.warn("read as `gpu: true` and `gui: true`: the old run script shared the display and NVIDIA's GPU", where)
    return True


def _paper(reading: Reading, root: Mapping) -> Base:
    """Read the paper's base images: ros-base, or with ``runtime: nvidia`` desktop-full with OpenGL headers."""
    distro = reading.value(root, "distro", "base.ros")
    runtime = reading.value(root, "runtime", "base.opengl")
    if runtime is None:
        return Base(ros=distro)
    if distro is not None:
        distro = f"{distro}-desktop-full"
    return Base(ros=distro, opengl="devel")


def _ubuntu(reading: Reading, text: Text | None) -> str | None:
    if text is None:
        return None
    codename = str(vocabulary.rows("ubuntu").get(text.value, text.value))
    if text.value == "melodic":
        reading.warn("`ubuntu: melodic` is a ROS distribution's name and means `bionic` (18.04)", text.node)
    return codename


def _agree(reading: Reading, ubuntu: str | None, ros: Text | None, mapping: Mapping | None) -> None:
    """Report a ROS distribution that has no packages for the Ubuntu release: nothing could be installed."""
    if ubuntu is None or ros is None or mapping is None or "image" in mapping.names:
        return
    distro = ros.value.partition("-")[0]
    releases = releases_of()[distro]
    if ubuntu not in releases:
        hint = f"write `ubuntu: {releases[-1]}`, or leave `ubuntu` out"
        reading.complain(f"base.ros: ROS {distro} has no packages for Ubuntu {ubuntu}", hint, ros.node)


def _cuda(reading: Reading, mapping: Mapping | None, generation: Generation) -> tuple[str | None, Flavour | None]:
    text = reading.text(mapping, "cuda", "base.cuda")
    version, flavour = _split(text)
    if text is None or version is None:
        return None, None
    gone = vocabulary.rows("cuda").get(version.partition(".")[0])
    if gone:
        reading.warn(f"{gone}: the image is made another way, or with a newer CUDA", text.node)
    return version, flavour or ("devel" if generation == "interim" else None)


def _split(text: Text | None) -> tuple[str | None, Flavour | None]:
    if text is None:
        return None, None
    version, _, flavour = text.value.partition("-")
    return version, cast(Flavour, flavour) if flavour else None


def _icub(reading: Reading, mapping: Mapping | None) -> bool:
    text = reading.text(mapping, "icub", "base.icub")
    if text is None or (isinstance(text.node, Scalar) and text.value.lower() in {"false", "no", "off"}):
        return False
    reading.warn("the iCub packages come from icub.org: the build fails once that site no longer answers", text.node)
    return True
