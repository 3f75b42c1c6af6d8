"""The libraries that the image builds from their source: those of the table, and those that a page builds or names."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.config.model import Config, Kind, Source
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.by_page import by_own_source, installed_beside
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.by_hand import as_written, built_by_hand, by_hand
from roslab.decide.system.contributed import with_contributed
from roslab.decide.system.libtorch import libtorch
from roslab.decide.system.listed_here import built_for_page, too_old_for_page
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.needs import TOOLKIT, needs
from roslab.decide.system.offered import with_offered
from roslab.decide.system.on_cuda import with_cuda
from roslab.decide.system.packages import SystemPackages
from roslab.decide.system.recipes import (
    of_another_release,
    own_names,
    recipes_for,
    refused_here,
    required_releases,
    too_new_here,
    too_old_here,
)
from roslab.decide.system.required import by_pip
from roslab.decide.system.without_cuda import without_cuda
from roslab.decide.system.wrapped import wrapped
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.apt_sources import folder_of_package
from roslab.knowledge.libraries import packaged
from roslab.values.dataclass import replace


def decide_libraries(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    target: Target,
    packages: Packages,
    sources: Sources,
    system: SystemPackages,
    folder_name: str,
    cuda: str | None,
) -> tuple[tuple[Source, Dependency], ...]:
    """Return the libraries in the order to build them, each with what asked for it; none is the repository itself.

    ``cuda``: the version that the image has.
    """
    own = own_names(evidence, folder_name)
    required = () if config.compatible else tuple(required_releases(needs(evidence, packages, kind, target.ros_distro)))
    listed = () if config.compatible else tuple(too_old_for_page(evidence, target))
    of_ros = (name for name in system.apt_guessed if name.startswith("ros-"))
    wanted = (
        *sources.libraries,
        *system.recipes,
        *(_of_extensions(evidence, packages, target) if kind in {"python", "cuda"} else ()),
        *of_another_release(evidence, system.apt_guessed),
        *too_old_here(evidence, (*system.apt, *of_ros), target),
        *too_new_here(evidence, target),
        *refused_here(required, target),
        *built_for_page(listed),
    )
    tabled = as_written(
        recipes_for(wanted, target.ubuntu, (*evidence.limits, *required, *listed), own, evidence.pip_day), evidence
    )
    if not config.compatible:
        tabled = tuple((with_packages(each, evidence, system), asked) for each, asked in tabled)
    submodules = (git.name for git in evidence.sources if git.kind == "submodule")
    elsewhere = {plain(name) for name in (*submodules, *(source.name for source, _ in tabled))}
    taken = sources.names | ((packages.names | own) - wrapped(evidence)) | elsewhere
    taken |= {plain(name) for name in by_own_source((git.name for git in evidence.sources), evidence)}
    guessed = (name for name in system.apt_guessed if name in packaged(target.ubuntu))  # a page's may not exist
    given = () if config.compatible else config.apt  # as a repair gives what a library's own build asked for
    depends = (*(name for name in (*system.apt, *system.brought, *guessed) if name.endswith("-dev")), *given)
    linked = by_hand(evidence, config, kind, target=target, packages=packages, taken=taken)
    torch = libtorch(evidence, config, kind, packages, cuda) if "libtorch" not in taken else ()
    needing = (
        (replace(each, depends=tuple(dict.fromkeys((*depends, *each.depends)))), asked) for each, asked in linked
    )
    needing = ((each if config.compatible else with_packages(each, evidence, system), asked) for each, asked in needing)
    built = with_offered((*tabled, *torch, *needing), built_by_hand(evidence), evidence, system.installed)
    built = built if config.compatible else with_contributed(built, evidence)
    if not (cuda or TOOLKIT in system.apt):
        return without_cuda(built)
    return built if config.compatible else with_cuda(built, evidence, system.installed, target.ubuntu, cuda)


def with_packages(library: Source, evidence: Evidence, system: SystemPackages) -> Source:
    """Return a library with the packages of it that a page installs from a source of apt which it adds before.

    Or from one that is added for them, whose packages are called after it (``robotpkg-py38-pinocchio``).
    """
    beside = installed_beside(library.name, evidence)
    named = re.compile(rf"[a-z]+-(?:py\d+-)?{re.escape(library.name)}")
    names = [name for name in system.installed if name in beside or (named.fullmatch(name) and folder_of_package(name))]
    return replace(library, instead=tuple(names))


def _of_extensions(evidence: Evidence, packages: Packages, target: Target) -> Iterator[tuple[str, Dependency]]:
    """Yield the libraries that the CMake of a project requires which pip compiles: without them pip stops there."""
    for _, asked in by_pip(evidence, packages):
        if name := resolve(asked, target).recipe:
            yield name, asked
