"""What pip has to compile while the image is built, and what that takes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.compiled import (
    architectures,
    gpu_options,
    gpu_variables,
    newest_gpu_of_torch,
    prebuilt,
    public_hosts,
)
from roslab.knowledge.frameworks import build_needs
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.version import Version

_RUST = frozenset({"maturin", "setuptools-rust"})
COMPILED_ON_IMPORT = frozenset({"meson-python", "scikit-build-core"})
"""What they need for it is gone by then.

https://mesonbuild.com/meson-python/how-to-guides/editable-installs.html
https://scikit-build-core.readthedocs.io/en/latest/configuration/index.html#editable-installs, 2026-11-22"""
_CLOSED = pattern(r"(?:\w+\+)?(?:git|ssh)://(?:[^@/]*@)?([\w.-]+)/|(?:\w+\+)?git@([\w.-]+):")
"""An address that needs a key, or a protocol that GitHub ended on 2022-03-15.

https://github.blog/security/application-security/improving-git-protocol-security-github/"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Compiling:
    """What the builds of Python packages need that a base may lack."""

    compiler: bool = False
    """Something may have no wheel: it takes a C++ compiler and Python's headers."""
    rust: bool = False
    git: bool = False
    hosts: tuple[str, ...] = ()
    """Public hosts that a line names by ``git://`` or ``ssh://``; all of them answer to https."""
    copied: tuple[str, ...] = ()
    """Folders of projects that are not installed editable: they would compile themselves again when imported, or what
    they compile would be missing (https://github.com/diegoferigo/cmake-build-extension, ``disable_editable``)."""
    architectures: str = ""
    """``TORCH_CUDA_ARCH_LIST`` for extensions of torch: it asks the GPU otherwise, and a build sees none."""
    gpus: tuple[tuple[str, str], ...] = ()
    """Variables in which packages are told the same in a way of their own, with their values."""
    options: tuple[tuple[str, str], ...] = ()
    """Lines of pip that are installed by themselves, each with the option of its setup.py that compiles for GPUs."""


NOTHING = Compiling()


def decide_compiling(
    projects: Sequence[PythonProject],
    installed: Iterable[Requirement],
    cuda: str | None,
    evidence: Evidence | None = None,
    by_script: Iterable[str] = (),
) -> Compiling:
    """Return what it takes to build the ``projects`` and what they ask for, on an image with that ``cuda``.

    ``evidence`` has the hosts that other build files name by ``git://``, and what CMake fetches as a branch, which it
    does for pip too; ``by_script``: extensions that scripts compile.
    """
    packages = [each for each in installed if each.package]
    build = {each.key for project in projects for each in project.build_requires}
    extensions = {*by_script, *(extension for project in projects for extension in project.extensions)}
    rust = bool(build & _RUST)
    on_torch = "cuda" in extensions or any("torch" in build_needs().get(each.key, ()) for each in packages)
    # What no table knows may be an extension too: these variables do no harm where it is none
    on_torch = on_torch or (any(each.vcs for each in packages) and any(each.key == "torch" for each in packages))
    closed = {match[1] or match[2] for each in packages if (match := _CLOSED.match(each.url))}
    closed |= {*(evidence.unsafe_hosts if evidence else ())}
    heads = any(mention.topic == "cloned_head" for mention in evidence.mentions) if evidence and projects else False
    torch = next((each.release for each in packages if each.key == "torch" and each.release), None)
    torch_for = _architectures(cuda, torch) if cuda and on_torch else ""
    return Compiling(
        compiler=bool(extensions) or rust or any(each.vcs or each.key not in prebuilt() for each in packages),
        rust=rust,
        git=heads or any(each.vcs for each in packages),
        copied=tuple(
            p.folder or "."
            for p in projects
            if {each.key for each in p.build_requires} & COMPILED_ON_IMPORT or "not editable" in p.extensions
        ),
        hosts=tuple(sorted(closed & public_hosts())),
        architectures=torch_for,
        gpus=tuple(dict.fromkeys(_told(each.key, torch_for) for each in packages if each.key in gpu_variables()))
        if torch_for
        else (),
        options=tuple({each.key: (each.text, gpu_options()[each.key]) for each in packages if _optioned(each)}.values())
        if torch_for
        else (),
    )


def _optioned(asked: Requirement) -> bool:
    """Tell whether a package is compiled for GPUs by an option alone, and taken as installed by pip's later calls."""
    return asked.key in gpu_options() and (not asked.url or asked.vcs) and asked.role in {"", "listed"}


def _architectures(cuda: str, torch: str | None) -> str:
    """Return the GPUs that the newest row not above this CUDA names, without those that a pinned torch refuses."""
    known = [(Version(version), names) for version, names in architectures() if Version(version) <= Version(cuda)]
    names = max(known)[1] if known else ""
    newest = newest_gpu_of_torch(torch) if torch else None
    if newest is None or not names:
        return names
    kept = [each for each in names.removesuffix("+PTX").split(";") if Version(each) <= newest]
    return f"{';'.join(kept)}+PTX" if kept else ""


def _told(package: str, architectures: str) -> tuple[str, str]:
    """Return the variable that a package reads, and the GPUs as it wants them: ``70;75;80``."""
    variable, lowest = gpu_variables()[package]
    numbers = [each for each in architectures.removesuffix("+PTX").split(";") if Version(each) >= lowest]
    return variable, ";".join(each.replace(".", "") for each in numbers)
