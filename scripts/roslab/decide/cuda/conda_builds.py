"""What a conda environment says of CUDA, as a package or by the builds of its frameworks, for a GPU or the CPU."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.cuda.local import cuda_of_build
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.knowledge.frameworks import conda_names, family_of
from roslab.values.conda import CondaPackage
from roslab.values.pattern import pattern
from roslab.values.version import minor_of

BUILT_FOR = frozenset({"torch", "torchvision", "torchaudio", "torch-scatter", "mmcv-full", "jaxlib", "cupy"})
OF_CONDA = frozenset({"cudatoolkit", "pytorch-cuda", "cuda-toolkit", "cuda-version", "cuda"})
"""Packages of conda whose version is that of CUDA."""
_TORCH = "torch"
_CHOOSING = frozenset({"cpuonly", "pytorch-cpu"})
"""Packages that take the builds of torch for the CPU. https://anaconda.org/pytorch/cpuonly, 2026-11-27."""
_MUTEX = "pytorch-mutex"
_OF_CPU = pattern(r"(?:^|.*_)cpu(?:_.*)?")
"""A build for the CPU: ``py3.7_cpu_0``, ``py37_cpu``, ``cpu_generic_py310…``; that of the mutex is ``cpu`` alone.
https://anaconda.org/pytorch/pytorch/files, https://anaconda.org/conda-forge/pytorch/files, 2026-11-27."""

_BETWEEN = pattern(r"[=\s]+")
"""What stands between the parts of a line: ``name=version=build``."""


def names_cuda(package: CondaPackage) -> bool:
    """Tell whether a package is CUDA itself in a version, or a framework in a build for one."""
    if package.name in OF_CONDA:
        return bool(minor_of(package.version))
    return _of_pip(package) in BUILT_FOR and bool(cuda_of_build(package.build))


def built_for(environment: CondaEnvironment) -> Iterator[tuple[str, bool]]:
    """Yield each package that is a framework, by the names of conda and pip, and whether its build is for the CPU.

    torch and what is released with it is where a package chooses these builds, unless CUDA stands beside it.
    """
    packages = environment.packages
    cuda = any(each.name in OF_CONDA or names_cuda(each) for each in packages)
    chosen = not cuda and any(each.name in _CHOOSING or (each.name == _MUTEX and _cpu(each)) for each in packages)
    for package in packages:
        name = _of_pip(package)
        cpu = _cpu(package) or (chosen and name in family_of(_TORCH))
        yield from ((each, cpu) for each in dict.fromkeys((package.name, name)))


def _of_pip(package: CondaPackage) -> str:
    return conda_names().get(package.name, package.name) or package.name


def _cpu(package: CondaPackage) -> bool:
    """Tell whether the build is one for the CPU, which may be asked for by a part of it: ``pytorch=*=cpu*``."""
    parts = _BETWEEN.split(package.written)
    build = package.build or (parts[2] if len(parts) == 3 else "")
    return bool(_OF_CPU.fullmatch(build.replace("*", "")))
