"""A compiler that is older than the code: its Ubuntu was chosen for the ROS that something names."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from roslab.config.model import Config
from roslab.decide.decision import Choice, Reason
from roslab.decide.reasons import because, warn
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.code_limits import fits
from roslab.knowledge.newer_compilers import newer_compiler, repository_of
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.version import Version

if TYPE_CHECKING:
    from roslab.decide.assembled import Choices

WEIGHT = 90
"""Nothing competes with it."""
_GCC = "GCC"
_LIBRARY, _WITH_LIBRARY, _WITHOUT_LIBRARY = "stdc++fs", "8", "9"
"""GCC 8 has std::filesystem in a library of its own: https://gcc.gnu.org/gcc-9/changes.html"""
_TOOLCHAIN = "ubuntu-toolchain-r/"
"""The owner of the PPAs with compilers."""
_COMPILER = pattern(r"(?:g\+\+|gcc)-(\d+(?:\.\d)?)")
"""Clang takes the headers of the GCC that is there."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Compiler:
    """A compiler that is installed beside the Ubuntu's own, and compiles in its place."""

    apt: tuple[str, ...] = ()
    repositories: tuple[str, ...] = ()
    variables: tuple[tuple[str, str], ...] = ()


NONE = Compiler()


def decide_compiler(of: Choices, evidence: Evidence, config: Config) -> Choice[Compiler]:
    """Return the compiler where the code needs a newer GCC than the Ubuntu has: one of the image, else of the table.

    What is installed beside the Ubuntu's own compiles nothing by itself: CMake and make take ``g++``. So one that
    roslab.yaml installs compiles too, and none where it names a compiler. CUDA's compiler takes few releases of GCC:
    there it is told, as where none is known.
    """
    ubuntu = None if of.own.answer else of.base.answer.ubuntu
    if ubuntu is None or config.compatible or {"CC", "CXX"} & {name for name, _ in config.env}:
        return Choice(answer=NONE)
    asked = [each for each in evidence.limits if each.library == _GCC and each.at_least and not places.aside(each.file)]
    newest = max(asked, key=lambda each: Version(each.at_least or "0"), default=None)
    if newest is None or fits(_GCC, ubuntu, at_least=newest.at_least, below=None):
        return Choice(answer=NONE) if of.on_cuda else _installed(of, evidence, config, ubuntu)
    needed = newest.at_least or "0"
    there = (each for each in _releases(_by_apt(of)) if _is_there(of, ubuntu, each))
    brought = sorted((*there, *_releases(config.apt)), key=Version)
    own = next((each for each in brought if Version(each) >= Version(needed)), None)
    wanted = _WITHOUT_LIBRARY if needed == _WITH_LIBRARY and not _links(evidence) else needed
    version = own or (None if of.on_cuda else newer_compiler(ubuntu, wanted))
    if version is None:
        message = (
            f"the code needs GCC {needed} or newer ({newest.what}), and {ubuntu} has an older one: what includes "
            "it does not compile; install a newer compiler by `custom` in roslab.yaml and name it there under `env` "
            "(CC, CXX), or set base.ubuntu or base.ros to one that has it"
        )
        return Choice(answer=NONE, warnings=(warn(message, newest),))
    why = f"the code needs GCC {needed} or newer ({newest.what}), and {ubuntu} has an older one"
    return _taken(of, config, ubuntu, version, because("dependencies", f"g++-{version}", why, newest, weight=WEIGHT))


def _links(evidence: Evidence) -> bool:
    return any(asked.name == _LIBRARY for project in evidence.cmake for asked in project.dependencies)


def _installed(of: Choices, evidence: Evidence, config: Config, ubuntu: str) -> Choice[Compiler]:
    """Return the newest compiler that roslab.yaml installs, else the only newer one that pages and CI do.

    Of several, CI tries the code with each.
    """
    given, named = _newer(config.apt, ubuntu), _newer(_by_apt(of), ubuntu)
    if given:
        return _taken(of, config, ubuntu, given[-1])
    if len(named) != 1 or not _is_there(of, ubuntu, named[0]):
        return Choice(answer=NONE)
    why = f"it is installed beside the older one of {ubuntu}, and no other newer one is"
    said = next((each for each in evidence.prose if each.name == f"g++-{named[0]}"), None)
    reason = because("dependencies", f"g++-{named[0]}", why, said, weight=WEIGHT)
    return _taken(of, config, ubuntu, named[0], reason)


def _by_apt(of: Choices) -> tuple[str, ...]:
    return (*of.system.answer.apt, *of.system.answer.apt_guessed)


def _is_there(of: Choices, ubuntu: str, version: str) -> bool:
    """Tell whether a release can be had: what a page installs may be of another Ubuntu."""
    return repository_of(ubuntu, version) is not None or any(_TOOLCHAIN in each for each in of.repositories.answer)


def _newer(apt: Iterable[str], ubuntu: str) -> list[str]:
    """Return the releases of compilers of C++ among packages that are newer than the Ubuntu's own."""
    found = _releases(name for name in apt if name.startswith("g++-"))
    return [each for each in found if not fits(_GCC, ubuntu, at_least=each, below=None)]


def _releases(apt: Iterable[str]) -> list[str]:
    """Return the releases of GCC among packages, oldest first."""
    return sorted({match[1] for name in apt if (match := _COMPILER.fullmatch(name))}, key=Version)


def _taken(of: Choices, config: Config, ubuntu: str, version: str, *reasons: Reason) -> Choice[Compiler]:
    """Return a compiler with the PPA that has it, if any, which may be added already."""
    name = f"g++-{version}"
    repository, added = repository_of(ubuntu, version), {*of.repositories.answer, *config.repositories}
    return Choice(
        answer=Compiler(
            apt=() if name in config.apt else (name,),
            repositories=(repository,) if repository and repository not in added else (),
            variables=(("CC", f"gcc-{version}"), ("CXX", name)),
        ),
        reasons=reasons,
    )
