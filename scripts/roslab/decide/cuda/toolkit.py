"""How much of CUDA an image needs: its compiler, its libraries, or only what the driver's users share."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from roslab.decide.python.packages import Chosen
from roslab.decide.python.pins import of_conda
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.accelerated import plugin_of_jax
from roslab.knowledge.compiled import without_nvcc
from roslab.knowledge.frameworks import build_needs
from roslab.knowledge.other_backends import other_backends
from roslab.values.name import of_fork
from roslab.values.requirement import Requirement

_OF_CUDA = frozenset({"CUDA", "CUDAToolkit", "Torch"})
"""What a CMakeLists.txt finds to compile for the GPU."""
Toolkit = Literal["devel", "runtime", "base"]
_WITH_NVCC = frozenset({"pycuda", "tensorrt", "triton", "taichi", "nvidia-dali"})
_BRING_CUDA = frozenset({"torch", "torchvision", "torchaudio"})
"""Their wheels hold CUDA's libraries, and nothing else asks for them. https://github.com/pytorch/pytorch/wiki"""
_USE_IT = ("tensorflow", "jax", "cupy", "onnxruntime-gpu", "paddlepaddle", "mxnet", "numba", "keras", "theano")
"""They load the libraries of the system; JAX those of NVIDIA's wheels, where a list has them."""
_CUDNN = "nvidia-cudnn-cu"


def decide_toolkit(evidence: Evidence, chosen: Chosen) -> Toolkit:
    """Return ``devel`` where anything may be compiled for the GPU, ``base`` where the wheels bring all of CUDA."""
    asked = [each for each in _asked(evidence, chosen) if each.package]
    if _compiled(evidence, chosen, asked) or not asked:
        return "devel"
    names = {each.key for each in asked}
    of_jax = any(map(plugin_of_jax, names)) and any(name.startswith(_CUDNN) for name in names)
    use = {name for name in names - other_backends().keys() if name.startswith(_USE_IT)}
    use = {name for name in use if not (of_jax and name.startswith("jax"))}
    return "base" if (of_jax or names & _BRING_CUDA) and not use else "runtime"


def extends_torch(evidence: Evidence, chosen: Chosen) -> bool:
    """Tell whether something that pip builds is compiled against the torch of the image."""
    if any("cuda" in project.extensions for project in chosen.projects):
        return True
    return any("torch" in build_needs().get(each.key, ()) for each in _asked(evidence, chosen))


def by_script(evidence: Evidence) -> tuple[str, ...]:
    """Return ``cuda`` if a page runs a script to compile, and the tree has extensions of torch for the GPU."""
    if not any(m.topic == "build_script" and m.source == "readme" for m in evidence.mentions):
        return ()
    own = (project for project in evidence.python if not places.aside(project.file))
    return ("cuda",) if any("cuda" in project.extensions for project in own) else ()


def _compiled(evidence: Evidence, chosen: Chosen, asked: Iterable[Requirement]) -> bool:
    """Tell whether CUDA sources are in the tree, or may be in what pip fetches."""
    own = any("cuda" in p.macros and not places.vendored(p.file) and not places.example(p.file) for p in evidence.cmake)
    if evidence.cuda_files or own or any(_on_cuda(project, evidence) for project in chosen.projects):
        return True
    for authored in evidence.dockerfiles:
        if authored.purpose == "project" and "-devel" in (authored.base or ""):
            return True
    return any(each.key in _WITH_NVCC or "torch" in _needs(each) for each in asked)


def _on_cuda(project: PythonProject, evidence: Evidence) -> bool:
    """Tell whether a project compiles for the GPU: by its setup.py, with torch, or by a CMakeLists.txt that says so.

    Of one that calls CMake where there is no CMakeLists.txt, nobody knows.
    """
    kinds = {*project.extensions}
    if kinds & {"cuda", "gpu", "gpu asked"}:
        return True
    if "torch" in project.setup_imports or any(each.key == "torch" for each in project.build_requires):
        return bool(kinds)
    inside = f"{project.folder}/" if project.folder else ""
    made = [each for each in evidence.cmake if each.file.startswith(inside)]
    return "cmake" in kinds and (not made or any(map(_names_cuda, made)))


def _names_cuda(made: CMakeProject) -> bool:
    asked = {each.name for each in made.dependencies if each.namespace == "cmake"}
    return made.cuda or "cuda" in made.macros or "CUDA" in made.languages or not _OF_CUDA.isdisjoint(asked)


def _needs(asked: Requirement) -> Iterable[str]:
    """Return what a package is built with; of what is built from git, and is of no table, nobody knows."""
    name = of_fork(asked.name) if asked.vcs else asked.key
    if asked.vcs and name in without_nvcc():
        return ()
    return build_needs().get(name, ("torch",) if asked.vcs else ())


def _asked(evidence: Evidence, chosen: Chosen) -> Iterable[Requirement]:
    """Yield everything that pip or conda installs."""
    for file in chosen.files:
        yield from file.requirements
    for project in chosen.projects:
        yield from (each for each in project.requirements if each.role not in {"extra", "test"})
    for environment in evidence.conda:
        if environment.file == chosen.conda:
            yield from environment.requirements
            yield from of_conda(environment)
    yield from chosen.declared
    yield from chosen.guessed
