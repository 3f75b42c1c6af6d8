"""Frameworks, CUDA images, wheels and imports: the tables about Python, loaded on first use."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped, record
from roslab.knowledge.table import cells, rows
from roslab.values.dataclass import dataclass
from roslab.values.version import Version, minor_of, version_of


@dataclass(frozen=True, kw_only=True, slots=True)
class Framework:
    """The Python and CUDA versions that one release series of a package runs with."""

    package: str
    first: str
    cuda: tuple[str, ...]
    """CUDA of the wheel that pip installs by default, then those of its other wheels."""
    cudnn: str | None
    python_min: str
    python_max: str
    source: str
    released: str
    """Day of its first release on the index, ``""`` where the tables do not tell."""

    def runs_with(self, python: str) -> bool:
        """Tell whether it has wheels for a Python (``3.8``)."""
        return Version(self.python_min) <= Version(python) <= Version(self.python_max)


@cache
def _rows() -> dict[str, tuple[dict[str, str], ...]]:
    """Return the rows of each package."""
    return grouped((row["package"], row) for row in rows("frameworks"))


@cache
def _days() -> dict[tuple[str, str], str]:
    """Return the day of each first release, by its package and number."""
    return {(row["package"], row["first"]): row["released"] for row in rows("framework_releases")}


def released_on(package: str, first: str) -> str:
    """Return the day of the first release of a series (``YYYY-MM-DD``). Raises KeyError for one without a row."""
    return _days()[package, first]


@cache
def _series(package: str) -> tuple[tuple[Version, Framework], ...]:
    """Return the release series of a package, each with its first release, the newest first; none if it has no row."""
    found = [
        (
            Version(row["first"]),
            record(
                Framework,
                row,
                cuda=tuple(f"{row['cuda']} {row['other_cuda']}".split()),
                released=_days().get((package, row["first"]), ""),
            ),
        )
        for row in _rows().get(package, ())
    ]
    return tuple(sorted(found, key=lambda pair: pair[0], reverse=True))


@cache
def _same_releases() -> dict[str, tuple[str, bool]]:
    return {row["pip"]: (row["framework"], row["cuda"] == "yes") for row in rows("framework_names")}


def tabled(package: str) -> str:
    """Return the name under which the table has a package: ``tensorflow`` for ``tensorflow-gpu``."""
    return _same_releases().get(package, (package, False))[0]


@cache
def framework_sources() -> dict[str, str]:
    """Return the packages with wheels whose repository takes hours to compile, by ``owner/name``."""
    return {row["repository"]: row["pip"] for row in rows("framework_sources")}


@cache
def released_together() -> dict[str, tuple[str, ...]]:
    """Return, for each framework, the packages of which each release is built for one release of it."""
    return grouped((row["framework"], row["pip"]) for row in rows("released_together"))


@cache
def family_of(framework: str) -> frozenset[str]:
    """Return a framework with the packages of which each release is built for one of its own."""
    return frozenset((framework, *released_together().get(framework, ())))


def same_numbers() -> str:
    """Return, a line each, a framework and what is released with it under the same number."""
    return "\n".join(
        f"{row['framework']} {row['pip']}" for row in rows("released_together") if row["same_number"] == "yes"
    )


def framework_on_cuda(package: str) -> str | None:
    """Return the name under which the table has a package whose wheels compute on CUDA, ``None`` for all others."""
    name, on_cuda = _same_releases().get(package, (package, True))
    return name if on_cuda and any(series.cuda for _, series in _series(name)) else None


def never_released(package: str, release: str) -> bool:
    """Tell whether a release (``0.7.0``, ``0.7``) is between two that follow each other: there never was such a one.

    A page that names one of them means another package, or has a slip.
    """
    gaps = _gaps().get(tabled(package), ())
    version = version_of(release) if gaps else None
    numbers = Version(version.base_version) if version else None
    return numbers is not None and any(first <= numbers < before for first, before in gaps)


@cache
def _gaps() -> dict[str, tuple[tuple[Version, Version], ...]]:
    """Return the numbers that each package left out: from the first, and up to the next release."""
    return grouped((row["package"], (Version(row["first"]), Version(row["before"]))) for row in rows("never_released"))


def framework(package: str, release: str) -> Framework | None:
    """Return the row for a release, ``None`` if the table has none, or there never was such a release."""
    numbers = None if never_released(package, release) else _numbers(release)
    series = _series(tabled(package))
    return next((row for first, row in series if numbers and first <= numbers), None)


def meant_framework(package: str, release: str) -> Framework | None:
    """Return the row for a release, that of the newest one before it where there never was such a release."""
    return last_below(tabled(package), release) if never_released(package, release) else framework(package, release)


def newest_framework(
    package: str, day: str | None = None, python: str | None = None, below: str | None = None
) -> Framework | None:
    """Return the row for the newest release (of a day, ``below`` another), ``None`` for one that is not in the table.

    Of those with wheels for a ``python``, where there are any.
    """
    known = _series(tabled(package))
    series = [row for first, row in known if (day is None or row.released <= day) and _before(first, below)]
    fitting = (row for row in series if python is None or row.runs_with(python))
    return next(fitting, series[0] if series else None)


def newest_on_cuda(
    package: str, cuda: str, python: str | None, day: str | None = None, below: str | None = None
) -> Framework | None:
    """Return the row of the newest release (of a day, ``below`` another) with wheels for a CUDA and a Python.

    Any if these are not known.
    """
    for first, row in _series(package):
        fits = (python is None or row.runs_with(python)) and _before(first, below)
        if cuda in row.cuda and fits and (day is None or row.released <= day):
            return row
    return None


def oldest_on_cuda(package: str, cuda: str, python: str | None) -> Framework | None:
    """Return the row of the oldest release with wheels for a CUDA and a Python, any if that is not known."""
    fits = (
        row for _, row in reversed(_series(package)) if cuda in row.cuda and (python is None or row.runs_with(python))
    )
    return next(fits, None)


def last_below(package: str, release: str) -> Framework | None:
    """Return the row of the newest release before this one, ``None`` if the table has none."""
    numbers = _numbers(release)
    return next((row for first, row in _series(package) if numbers and first < numbers), None)


def next_after(known: Framework) -> Framework | None:
    """Return the row of the series that follows another, ``None`` for the newest."""
    later = [row for first, row in _series(known.package) if first > Version(known.first)]
    return later[-1] if later else None


def _before(first: Version, below: str | None) -> bool:
    return below is None or first < Version(below)


def _numbers(release: str) -> Version | None:
    """Return only the numbers of a release: a candidate of 2.0 runs with the same versions as 2.0."""
    version = version_of(release)
    return Version(version.base_version) if version else None


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
    return tuple(record(CudaImage, row) for row in rows("cuda_images"))


def cuda_image(cuda: str) -> CudaImage | None:
    """Return the image row of a CUDA version (``11.8``), ``None`` where it is not known."""
    asked = minor_of(cuda)
    return next((image for image in cuda_images() if image.cuda == asked), None)


def nearest_cuda_image(cuda: str) -> CudaImage:
    """Return the oldest existing image that is not older than ``cuda``, else the newest one."""
    existing = [image for image in cuda_images() if image.tag]
    asked = Version(minor_of(cuda) or cuda)
    return next((image for image in existing if Version(image.cuda) >= asked), existing[-1])


@cache
def wheels() -> dict[str, tuple[str, ...]]:
    """Return the apt packages that each pip package needs but does not contain."""
    return {row["pip"]: tuple(row["apt"].split()) for row in rows("wheels")}


@cache
def older_wheels() -> dict[str, tuple[Version, tuple[str, ...]]]:
    """Return what only the wheels from before a release need: ``{pip package: (the release, apt packages)}``."""
    return {row["pip"]: (Version(row["before"]), tuple(row["apt"].split())) for row in rows("older_wheels")}


@cache
def build_needs() -> dict[str, tuple[str, ...]]:
    """Return what must be installed before a pip package can be built."""
    return {row["pip"]: tuple(row["first"].split()) for row in rows("build_needs") if not row["of_others"]}


@cache
def backend_needs() -> dict[str, tuple[str, ...]]:
    """Return what a backend asks pip for while it builds another project; itself it is a wheel that needs nothing."""
    return {row["pip"]: tuple(row["first"].split()) for row in rows("build_needs") if row["of_others"]}


@cache
def with_numpy_2() -> dict[str, str]:
    """Return the first release of each pip package whose wheels take NumPy 2, which they do not ask pip for."""
    return {row["pip"]: row["first"] for row in rows("with_numpy_2")}


@cache
def old_setuptools() -> tuple[tuple[str, str, str, str], ...]:
    """Return pip packages that need an older setuptools before a release of theirs: that release, a line of pip, why.

    The oldest release comes first.
    """
    found = ((row["pip"], row["before"], row["setuptools"], row["why"]) for row in rows("old_setuptools"))
    return tuple(sorted(found, key=lambda row: (row[0], Version(row[1]))))


@cache
def unstated() -> dict[str, str]:
    """Return what a pip package needs and does not ask pip for: people choose their build, or it came first."""
    return {row["pip"]: row["needs"] for row in rows("unstated")}


def instead_of(package: str) -> str:
    """Return what may replace a package whose unstated need cannot be met, with a word on it, ``""`` for nothing."""
    return next((row["instead"] for row in rows("unstated") if row["pip"] == package), "")


@cache
def kept_for_build_types() -> dict[str, tuple[tuple[str, str], ...]]:
    """Return, for each build type of a ROS package, what pip must not replace with a newer one, and why."""
    types = dict.fromkeys(row["build_type"] for row in rows("build_types"))
    return {
        name: tuple((row["pip"], row["why"]) for row in rows("build_types") if row["build_type"] == name)
        for name in types
    }


@cache
def conda_names() -> dict[str, str | None]:
    """Return ``conda → pip`` for packages with another name on pip's index, ``None`` for those not on it."""
    return {row["conda"]: row["pip"] or None for row in rows("conda_names")}


@cache
def imports() -> dict[str, tuple[str | None, str | None]]:
    """Return ``module → (pip, apt)``; ``None`` where there is no such package."""
    head, *lines = cells("imports")
    module, pip, apt = map(head.index, ("module", "pip", "apt"))
    return {line[module]: (line[pip] or None, line[apt] or None) for line in lines}
