"""The base image of plain Python and CUDA repositories."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from roslab.config.model import Kind
from roslab.decide.cuda.toolkit import Toolkit
from roslab.decide.decision import Reason
from roslab.knowledge.distros import python_of_ubuntu, ubuntus
from roslab.knowledge.frameworks import cuda_image, nearest_cuda_image
from roslab.values.version import Version

PREFERRED = ("focal", "jammy", "noble", "bionic", "xenial")
"""The Ubuntu when nothing decides: old enough for the code of papers, new enough to have packages."""
_WEIGHT = 50
"""There is one base for a Python or a CUDA: nothing speaks against it."""


def system_ubuntu(python_version: str | None, among: tuple[str, ...] = PREFERRED) -> str | None:
    """Return the Ubuntu whose own Python has that version."""
    return next((name for name in among if python_of_ubuntu().get(name) == python_version), None)


def version_of(codename: str) -> str:
    """Return ``20.04`` for ``focal``."""
    return next((number for number, name in ubuntus().items() if name == codename), "22.04")


def base_for(
    kind: Kind,
    cuda: str | None,
    cudnn: str | None,
    ubuntu: str | None,
    python_version: str | None,
    *,
    toolkit: Toolkit = "devel",
    lacking: Mapping[str, tuple[str, ...]] = MappingProxyType({}),
) -> tuple[str, str | None, tuple[Reason, ...]]:
    """Return the image, its Ubuntu codename (``None`` on Debian) and why.

    ``ubuntu`` is what the configuration asks for; an Ubuntu from the evidence is only taken if its Python fits.
    ``lacking``: what code that is compiled for CUDA lacks on an Ubuntu.
    """
    if kind == "cuda":
        # Frameworks expect cuDNN; plain CUDA programs get it if something names it
        with_cudnn = bool(cudnn or python_version)
        return _cuda(cuda or "11.8", ubuntu, python_version, cudnn=with_cudnn, toolkit=toolkit, lacking=lacking)
    if ubuntu is None and (fitting := system_ubuntu(python_version)):
        image = f"ubuntu:{version_of(fitting)}"
        return image, fitting, (_reason(image, f"its own Python is {python_version}"),)
    if ubuntu or python_version is None or python_version.startswith("2"):
        chosen = ubuntu or ("bionic" if python_version else "jammy")
        image = f"ubuntu:{version_of(chosen)}"
        return image, chosen, (_reason(image, "asked for" if ubuntu else "the default"),)
    from roslab.knowledge.python_images import python_images  # noqa: PLC0415 - most trees are built on Ubuntu

    image = f"python:{python_version}-slim-{python_images().get(python_version, 'bookworm')}"
    return image, None, (_reason(image, f"no Ubuntu has Python {python_version}"),)


def cuda_ubuntus(cuda: str | None) -> tuple[str, ...]:
    """Return the Ubuntus for which an image of CUDA exists, of the nearest one for a version that has none."""
    image = cuda_image(cuda or "11.8")
    return image.ubuntu if image and image.tag else nearest_cuda_image(cuda or "11.8").ubuntu


def cuda_ubuntu(
    cuda: str,
    ubuntu: str | None,
    python_version: str | None,
    lacking: Mapping[str, tuple[str, ...]] = MappingProxyType({}),
) -> str:
    """Return the Ubuntu of the CUDA image: the requested one, else the one with that Python, else one in the middle.

    Without a Python it is one on which the code compiles; ``lacking``: what it lacks on others.

    For a Python that is newer than that one's, the newest whose own is older still: wheels of such a Python are built
    for its C library.
    """
    among = cuda_ubuntus(cuda)
    if ubuntu in among:
        return str(ubuntu)
    if python_version is None:
        among = tuple(name for name in among if name not in lacking) or among
        if "jammy" in among:
            return "jammy"  # nothing needs an older one, and its CMake is new enough for projects that use CUDA
    fitting = system_ubuntu(python_version, among)
    middle = next((name for name in PREFERRED if name in among), among[-1])
    own = {name: Version(python_of_ubuntu()[name]) for name in among if name in python_of_ubuntu()}
    older = [name for name in own if python_version and own[name] < Version(python_version)]
    return fitting or max((middle, *older), key=lambda name: own.get(name, Version("0")))


def _cuda(
    cuda: str,
    ubuntu: str | None,
    python_version: str | None,
    *,
    cudnn: bool,
    toolkit: Toolkit,
    lacking: Mapping[str, tuple[str, ...]],
) -> tuple[str, str, tuple[Reason, ...]]:
    row = cuda_image(cuda)
    row = row if row and row.tag else nearest_cuda_image(cuda)
    chosen = cuda_ubuntu(cuda, ubuntu, python_version, lacking)
    flavour = f"{row.cudnn}-{toolkit}" if cudnn and toolkit != "base" else toolkit
    name = f"nvidia/cuda:{row.tag}-{flavour}-ubuntu{version_of(chosen)}"
    if chosen == ubuntu:
        why = f"CUDA {row.cuda} on the requested Ubuntu; -devel because extensions are compiled"
    elif python_version is None:
        why = f"the last patch of CUDA {row.cuda}; -devel because it is compiled"
    elif python_of_ubuntu().get(chosen) == python_version:
        why = f"the last patch of CUDA {row.cuda}, on the Ubuntu whose Python is {python_version}"
    else:
        why = f"the last patch of CUDA {row.cuda}; Python {python_version or ''} comes from conda".replace("  ", " ")
    why += {"devel": "", "runtime": "; nothing is compiled for it", "base": "; the wheels bring its libraries"}[toolkit]
    return name, chosen, (_reason(name, why, row.source),)


def _reason(answer: str, why: str, source: str | None = None) -> Reason:
    return Reason(question="base_image", answer=answer, reason=f"{why} ({source})" if source else why, weight=_WEIGHT)
