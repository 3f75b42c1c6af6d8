"""Packages of Debian that are installed by their files, and what the code cannot be compiled without of them."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable

from roslab.config.model import Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import because, warn
from roslab.decide.ros.by_page import packages_of
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose.own_packages import NAME
from roslab.evidence.x86_only import X86Only
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.launched_simulators import LaunchedSimulator
from roslab.values.pattern import pattern

_PLAIN = pattern(r"[\w./+~-]+|https?://(?![^/\s]*@)[\w./+~%:@-]+")
"""A path that a mount of a Dockerfile, whose options commas part, can name, or an address without a login."""
STARTED = 50
"""Weight of the reason; nothing competes with it."""
_WORD = pattern(r"[A-Za-z]+")
_NUMBER = pattern(r"ubuntu-?(\d\d)\.?(\d\d)(?!\d)")


def own_packages(
    evidence: Evidence,
    config: Config,
    ubuntu: str | None,
    simulators: Iterable[tuple[Dependency, LaunchedSimulator]],
    platforms: Collection[str],
) -> Choice[tuple[str, ...]]:
    """Return their paths or addresses in the order in which they are installed, of several with one name the first.

    One whose name says another Ubuntu than the image's is told and left out. After them the ``simulators`` that the
    default command starts, each with the import that asks for it; that they are for amd64 alone is told where the image
    is built for other ``platforms`` too.
    """
    if config.compatible:
        return Choice(answer=())
    found: dict[str, Mention] = {}
    for each in evidence.mentions:
        if each.topic == "own_package" and _PLAIN.fullmatch(each.value):
            found.setdefault(posixpath.basename(each.value), each)
    others = {name: meant for name in found if (meant := _ubuntu_of(name)) and ubuntu and meant != ubuntu}
    told = (
        warn(
            f"not installed: {found[name].value}, which is for Ubuntu {meant}, and the image has {ubuntu}", found[name]
        )
        for name, meant in others.items()
    )
    paths = tuple(each.value for name, each in found.items() if name not in others)
    more = tuple(simulators)
    reasons = [
        because(
            "dependencies",
            each.package,
            f"the default command starts {each.program} by {used.name}",
            used,
            weight=STARTED,
        )
        for used, each in more
    ]
    elsewhere = ", ".join(platform for platform in platforms if platform != "linux/amd64")
    alone = (
        warn(f"not in the image for {elsewhere}: {each.program}, which the default command starts", used)
        for used, each in more
        if elsewhere
    )
    paths += tuple(each.file for _, each in more)
    return Choice(answer=paths, reasons=tuple(reasons), warnings=(*told, *alone))


def _ubuntu_of(file: str) -> str:
    """Return the codename of the Ubuntu that the name of a file says, by its number or by itself, ``""`` for none."""
    by_number = _NUMBER.search(file)
    number = f"{by_number[1]}.{by_number[2]}" if by_number else ""
    version = file.partition("_")[2] or file
    words = {match[0] for match in _WORD.finditer(version)}
    return ubuntus().get(number, "") or next((name for name in ubuntus().values() if name in words), "")


def for_x86_alone(evidence: Evidence) -> X86Only | None:
    """Return the first for amd64 alone with the name of what CMake requires."""
    asked = [each for project in evidence.cmake for each in project.dependencies if each.strength == "declared"]
    paths = [each.value for each in evidence.mentions if each.topic == "own_package"]
    for_arm = {package_of_file(path) for path in paths if path.endswith(("_arm64.deb", "_all.deb"))}
    for path in paths:
        name = package_of_file(path)
        if path.endswith("_amd64.deb") and name not in for_arm:
            for each in asked:
                if name in packages_of(each.name.lower()):
                    return X86Only(path, "binary", each.file, each.line)
    return None


def package_of_file(path: str) -> str:
    """Return the package that a file is called after, ``""`` where its name tells none."""
    name = NAME.fullmatch(posixpath.basename(path))
    return name[1] if name else ""
