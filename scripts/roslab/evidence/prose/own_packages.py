"""Packages of Debian that pages and scripts install by their files: of the tree, or fetched by an address before."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import UNKNOWN
from roslab.evidence.prose.merged import Prose
from roslab.knowledge.never import never
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

NAME = pattern(r"([a-z0-9][a-z0-9+.-]+)_[^/_]+(?:_[^/]+)?\.deb")
"""``name_version_architecture.deb``: https://manpages.debian.org/bookworm/dpkg-dev/dpkg-name.1.en.html, 2026-11-26"""
_APT = frozenset({"apt", "apt-get"})
_DPKG = frozenset({"-i", "--install"})
_FETCHED = pattern(r"(?:wget|curl) (https?://(?![^/\s]*@)[\w./+~%:@-]+/([\w.+~%-]+\.deb))")
"""The step of a page or script that fetches one, as it is told where nothing repeats it.

An address with a login is none: a Dockerfile keeps no password."""
_SOURCE = pattern(
    r"(?:.*-)?(?:repo|keyring|apt-source|apt-config|release)(?:[-_].*)?|(?:lib)?(?:cuda|cudnn|nccl|nvinfer|nv-tensorrt).*"
)
"""A package that only adds a source of apt, or of CUDA, which is the base image's matter."""


def called(words: tuple[str, ...], folder: str) -> Iterator[str]:
    """Yield the paths of the packages that a command installs; to apt a file is a path with a folder in it."""
    program = words[0].rpartition("/")[2]
    by_apt = program in _APT and "install" in words
    if by_apt or program == "gdebi" or (program == "dpkg" and _DPKG & {*words}):
        for word in words[1:]:
            there = word.endswith(".deb") and "://" not in word and UNKNOWN not in word and (not by_apt or "/" in word)
            if there and word[:1] not in "/~$":
                yield posixpath.normpath(posixpath.join(folder, word))


def found(prose: Prose, repository: Repository) -> Prose:
    """Return what pages and scripts say with the packages among these that the image can have.

    Those that the tree has are named by their paths in it, those that the same text fetches before by their addresses.
    apt knows each by its name once it is there. Steps that only fetch or install such packages are no longer told.
    """
    fetched = _fetched(prose)
    mentions: list[Mention] = []
    asked: list[Dependency] = []
    here: set[tuple[str, int, str]] = set()
    for each in prose.mentions:
        if each.topic != "own_package":
            mentions.append(each)
        elif path := _path(each, repository) or _address(each, fetched):
            if step := fetched.get((each.file, posixpath.basename(path))):
                here.add((each.file, step.line, posixpath.basename(path)))
            mentions += (replace(each, value=there) for there in (path, *_for_arm(path, repository)))
            here.add((each.file, each.line, posixpath.basename(path)))
            if named := NAME.fullmatch(posixpath.basename(path)):
                asked.append(_by_name(named[1], each))
    kept = (m for m in mentions if m.topic != "step" or not _only(m, here))
    return replace(prose, mentions=tuple(kept), dependencies=(*prose.dependencies, *asked))


def _fetched(prose: Prose) -> dict[tuple[str, str], Mention]:
    """Return the steps that fetch such a package, by their text and the name of the file."""
    found: dict[tuple[str, str], Mention] = {}
    for each in prose.mentions:
        match = _FETCHED.fullmatch(each.value) if each.topic == "step" and each.value.endswith(".deb") else None
        if match:
            found.setdefault((each.file, match[2]), each)
    return found


def _address(mention: Mention, fetched: Mapping[tuple[str, str], Mention]) -> str:
    """Return the address from which a package comes that a later line of the same text installs, else ``""``."""
    name = posixpath.basename(mention.value)
    step = fetched.get((mention.file, name))
    package = name.partition("_")[0]
    if step is None or step.line > mention.line or never().fullmatch(package) or _SOURCE.fullmatch(package):
        return ""
    read = mention.source in {"readme", "script"} and not places.vendored(mention.file)
    return step.value.partition(" ")[2] if read else ""


def _path(mention: Mention, repository: Repository) -> str:
    """Return the path of a package of the tree: beside the script, from the root, or the only one of its name."""
    beside = posixpath.normpath(posixpath.join(posixpath.dirname(mention.file), mention.value))
    named = [file.path for file in repository.named(posixpath.basename(mention.value))]
    paths = [path for path in (beside, mention.value) if path in named] or (named if len(named) == 1 else [])
    read = mention.source in {"readme", "script"} and not places.vendored(mention.file)
    return paths[0] if paths and read else ""


def _for_arm(path: str, repository: Repository) -> list[str]:
    """Return the files of the same version of a package for amd64 that are for arm64, mentioned or not."""
    package, _, machine = posixpath.basename(path).rpartition("_")
    named = repository.named(f"{package}_arm64.deb") if machine == "amd64.deb" else ()
    return [file.path for file in named]


def _only(step: Mention, here: set[tuple[str, int, str]]) -> bool:
    files = [posixpath.basename(word) for word in step.value.split() if word.endswith(".deb")]
    return bool(files) and all((step.file, step.line, name) in here for name in files)


def _by_name(name: str, mention: Mention) -> Dependency:
    return Dependency(
        namespace="apt",
        name=name,
        strength="prose",
        file=mention.file,
        line=mention.line,
        heading=mention.heading,
    )
