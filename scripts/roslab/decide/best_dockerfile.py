"""Which of several Dockerfiles of the author's that can be built is the one for the repository."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.chains import wanted
from roslab.decide.system.code_fits import misfits
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.distros import codename_of, distros, ubuntus
from roslab.values.pattern import pattern

PUBLISHED = (
    "osrf/",
    "nvidia/",
    "nvcr.io/",
    "pytorch/",
    "tensorflow/",
    "continuumio/",
    "mambaorg/",
    "condaforge/",
    "ghcr.io/sloretz/",
    "library/",
    "mcr.",
)
"""What the names of images begin with that anybody can pull."""
_ACCELERATED = pattern(r"nvidia|nvcr\.io|cuda|pytorch|tensorflow|-gpu|rocm")
_ASIDE = pattern(
    r"(?:^|[/._-])(?:submi(?:t|ssion)|challenge|leaderboard|evaluat\w*|tests?|testing|debug|examples?|tutorials?)(?:[/._-]|$)"
)
"""A part of the path of a Dockerfile for something else than the program itself."""


def best_of(
    believed: list[AuthorDockerfile], evidence: Evidence, kind: Kind, ros_distro: str | None
) -> AuthorDockerfile:
    """Return the best of the usable Dockerfiles; of those for several Ubuntus one on which the code compiles.

    Where there is a ROS distribution, that has the Ubuntu; and on which one CI starts Python tells nothing.
    """
    if len(believed) == 1:
        return believed[0]
    named = built_by_pages(evidence)
    lacking = {} if kind in {"ros1", "ros2"} else misfits(evidence)
    run = _run_by_ci(evidence) if kind == "cpp" else frozenset()

    def fitting(authored: AuthorDockerfile) -> tuple[bool, bool]:
        codename = codename_of(authored.base or "")
        return codename in lacking, bool(run) and codename is not None and codename not in run

    return min(believed, key=lambda authored: _rank(authored, kind, ros_distro, named, fitting(authored)))


def _run_by_ci(evidence: Evidence) -> frozenset[str]:
    """Return the codenames of the Ubuntus that CI names."""
    said = (m for m in evidence.mentions if m.source == "ci" and m.topic == "ubuntu")
    return frozenset(ubuntus().get(mention.value, mention.value) for mention in said)


def built_by_pages(evidence: Evidence) -> frozenset[str]:
    """Return the Dockerfiles that the pages at the root have built: ``docker build -f docker/gpu.Dockerfile .``.

    Or by Docker Compose.
    """
    files = {authored.file for authored in evidence.dockerfiles}
    built = (m for m in evidence.mentions if m.topic == "image_built" and m.source == "readme" and "/" not in m.file)
    said = {wanted(mention.text.split()) for mention in built}
    below = {file for file in files for name in said - files if file.endswith(f"/{name}")}  # the page went there before
    composed = {authored.file for authored in evidence.dockerfiles if authored.service}
    return frozenset(said & files | below | composed)


def _rank(
    authored: AuthorDockerfile,
    kind: Kind,
    ros_distro: str | None,
    named: frozenset[str],
    unfit: tuple[bool, bool],
) -> tuple[object, ...]:
    """Return the sort key of usable Dockerfiles; the smallest is the best.

    In this order: no other distribution in the path, and no other purpose (``Dockerfile.submission``); a base that
    anybody can pull; one that a page has built (``named``); a base that suits the kind; an Ubuntu that the code
    compiles on, and one that CI runs (``unfit``: it is neither); few folders deep; the repository's distribution, or
    none, in the name; the newer Ubuntu.
    """
    path, base = authored.file.lower(), (authored.base or "").lower()
    mine = bool(ros_distro and ros_distro in path)
    other = any(name in path for name in distros() if name != ros_distro) and not mine
    aside = bool(_ASIDE.search(path))
    private = "/" in base and not base.startswith(PUBLISHED)
    unlike = kind in {"cuda", "cpp", "python"} and bool(_ACCELERATED.search(base)) != (kind == "cuda")
    plain = path.rpartition("/")[2] == "dockerfile"
    below = 0 if mine else max(0, path.count("/") - 1)  # docker/Dockerfile counts as one at the root
    codename = codename_of(base) if kind not in {"ros1", "ros2"} else None
    newest = -1 - [*ubuntus().values()].index(codename) if codename else 0
    said = authored.file in named
    depth = path.count("/")
    return (other, aside, private, not said, unlike, *unfit, below, not (mine or plain), depth, newest, authored.file)
