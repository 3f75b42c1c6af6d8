"""Frameworks, CUDA images, wheels and imports: the tables of the Python side, loaded when asked for."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from roslab.knowledge.table import rows

Version = tuple[int, ...]


def version(text: str) -> Version:
    """Return the numbers of a version: ``1.13.1+cu117`` → ``(1, 13, 1)``; ``()`` where it has none."""
    return tuple(int(number) for number in re.findall(r"\d+", text.partition("+")[0].partition("-")[0])[:4])


def canonical(name: str) -> str:
    """Return a package's name as the index compares it. https://peps.python.org/pep-0503/#normalized-names."""
    return re.sub(r"[-_.]+", "-", name).lower()


@dataclass(frozen=True, kw_only=True, slots=True)
class Framework:
    """What one release series of a package runs with."""

    package: str
    first: str
    cuda: tuple[str, ...]
    """CUDA of the wheel that pip gets by default, then those of the others."""
    cudnn: str | None
    python_min: str
    python_max: str
    source: str


@cache
def _frameworks() -> dict[str, tuple[Framework, ...]]:
    found: dict[str, list[Framework]] = {}
    for row in rows("frameworks"):
        found.setdefault(row["package"], []).append(
            Framework(
                package=row["package"],
                first=row["first"],
                cuda=tuple(f"{row['cuda']} {row['other_cuda']}".split()),
                cudnn=row["cudnn"] or None,
                python_min=row["python_min"],
                python_max=row["python_max"],
                source=row["source"],
            )
        )
    return {package: tuple(sorted(series, key=lambda row: version(row.first))) for package, series in found.items()}


def framework(package: str, release: str | None) -> Framework | None:
    """Return the row for a release (the newest for ``None``), ``None`` for what the table does not know."""
    series = _frameworks().get(package, ())
    if release is None:
        return series[-1] if series else None
    return next((row for row in reversed(series) if version(row.first) <= version(release)), None)


def last_below(package: str, release: str) -> Framework | None:
    """Return the row of the newest release before one, ``None`` for what the table does not know."""
    series = _frameworks().get(package, ())
    return next((row for row in reversed(series) if version(row.first) < version(release)), None)


@dataclass(frozen=True, kw_only=True, slots=True)
class CudaImage:
    """The images of one CUDA version that still exist."""

    cuda: str
    tag: str
    """Last patch, ``11.8.0``; ``""`` where every image was deleted."""
    cudnn: str
    """How a tag spells cuDNN: ``cudnn8``, later ``cudnn``."""
    ubuntu: tuple[str, ...]
    source: str


@cache
def cuda_images() -> tuple[CudaImage, ...]:
    """Return every CUDA version known, oldest first."""
    return tuple(
        CudaImage(
            cuda=row["cuda"],
            tag=row["tag"],
            cudnn=row["cudnn"],
            ubuntu=tuple(row["ubuntu"].split()),
            source=row["source"],
        )
        for row in rows("cuda_images")
    )


def cuda_image(cuda: str) -> CudaImage | None:
    """Return the image row of a CUDA version (``11.8``), ``None`` where it is not known."""
    return next((image for image in cuda_images() if version(image.cuda) == version(cuda)[:2]), None)


def nearest_cuda_image(cuda: str) -> CudaImage:
    """Return the oldest image that exists and is not older, else the newest there is."""
    existing = [image for image in cuda_images() if image.tag]
    return next((image for image in existing if version(image.cuda) >= version(cuda)[:2]), existing[-1])


@cache
def wheels() -> dict[str, tuple[str, ...]]:
    """Return the apt packages that each pip package needs and does not carry."""
    return {row["pip"]: tuple(row["apt"].split()) for row in rows("wheels")}


@cache
def build_needs() -> dict[str, tuple[str, ...]]:
    """Return what must be installed before a pip package can be built."""
    return {row["pip"]: tuple(row["first"].split()) for row in rows("build_needs")}


@cache
def kept_for_build_types() -> dict[str, tuple[tuple[str, str], ...]]:
    """Return, for each build type of a ROS package, what pip must not replace by a newer one, each with the reason."""
    types = dict.fromkeys(row["build_type"] for row in rows("build_types"))
    return {
        name: tuple((row["pip"], row["why"]) for row in rows("build_types") if row["build_type"] == name)
        for name in types
    }


@cache
def conda_names() -> dict[str, str | None]:
    """Return ``conda → pip`` for packages that the index has by another name, ``None`` for those that it has not."""
    return {row["conda"]: row["pip"] or None for row in rows("conda_names")}


@cache
def imports() -> dict[str, tuple[str | None, str | None]]:
    """Return ``module → (pip, apt)``; ``None`` where there is no such package."""
    return {row["module"]: (row["pip"] or None, row["apt"] or None) for row in rows("imports")}


@cache
def arm64_wheels() -> dict[str, str | None]:
    """Return the first release of a pip package with a Linux arm64 wheel, ``None`` for never."""
    return {row["pip"]: row["first"] or None for row in rows("arm64_wheels")}
