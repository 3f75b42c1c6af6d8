"""OpenCV for code that computes on its part for CUDA: Ubuntu's and ROS's are compiled without it, and stop there.

https://docs.opencv.org/3.4/d2/dbc/cuda_intro.html, 2026-11-27
"""

from __future__ import annotations

import shlex
from collections.abc import Collection, Iterable

from roslab.config.model import Source
from roslab.decide.cuda.gpus import gpu_limits
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.system.needs import TOOLKIT, host_options
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.compiled import architectures
from roslab.knowledge.cuda_toolkits import host_compilers, toolkits
from roslab.knowledge.recipes import OnCuda, on_cuda
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.version import Version

LIBRARY = "opencv"
_SIGN = "OpenCV on CUDA"
_ASKS = "a GPU that OpenCV finds"
"""The code asks whether OpenCV can compute on a GPU, and has another way where it cannot."""
_OFF = "-DWITH_CUDA=OFF"
_RELEASE = pattern(r"v?(\d+(?:\.\d+)+)")
_GPU = pattern(r"sm_(\d+)(\d)")
_ON = pattern(r"-DWITH_CUDA(?::\w+)?=(?!(?:OFF|FALSE|NO|0)\b)")


def needed(evidence: Evidence) -> CodeLimit | None:
    """Return the first place where the code takes OpenCV's part for CUDA as given."""
    if any(limit.library == _ASKS for limit in evidence.limits):
        return None
    return next((limit for limit in evidence.limits if limit.library == _SIGN), None)


def with_cuda(
    libraries: Iterable[tuple[Source, Dependency]],
    evidence: Evidence,
    apt: Collection[str],
    ubuntu: str | None,
    cuda: str | None,
) -> tuple[tuple[Source, Dependency], ...]:
    """Return the libraries, OpenCV of the table compiled for CUDA where the code needs that and CUDA compiles it.

    ``cuda``: the version that the base has; else the one of Ubuntu's toolkit counts, where it is among ``apt``.
    """
    version = cuda or (toolkits().get(ubuntu or "") if TOOLKIT in apt else None)
    found = tuple(libraries)
    known = on_cuda(LIBRARY)
    if version is None or known is None or needed(evidence) is None:
        return found
    compilers = () if cuda else tuple(filter(None, (TOOLKIT, host_compilers().get(ubuntu or ""))))
    options = (*_gpus(evidence, version), *(() if cuda else host_options(apt, ubuntu)[:1]))
    return tuple(
        (_with_depends(_compiled(source, known, evidence, options), compilers), asked)
        if source.tabled and source.name == LIBRARY and _fits(source, known, version)
        else (source, asked)
        for source, asked in found
    )


def _fits(source: Source, known: OnCuda, cuda: str) -> bool:
    release = release_of(source)
    off = _OFF in shlex.split(source.cmake_options)  # a page may say it
    old = Version(cuda) >= Version("12") and release is not None and release < Version(known.for_cuda_12)
    return off and release is not None and not old


def release_of(source: Source) -> Version | None:
    """Return the release that a library is built of, ``None`` for a commit or a branch."""
    match = _RELEASE.fullmatch(source.ref or "")
    return Version(match[1]) if match else None


def _with_depends(source: Source, packages: tuple[str, ...]) -> Source:
    return replace(source, depends=tuple(dict.fromkeys((*source.depends, *packages))))


def _compiled(source: Source, known: OnCuda, evidence: Evidence, options: tuple[str, ...]) -> Source:
    """Return OpenCV with its core for CUDA, and with its modules for CUDA where the code includes any of them."""
    included = {f"opencv2/{name}.hpp" for name in known.modules}
    whole = any(each.namespace == "include" and each.name in included for each in evidence.code)
    left_out = known.without if whole else (*known.modules, *known.without)
    words = [word if word != _OFF else "-DWITH_CUDA=ON" for word in shlex.split(source.cmake_options)]
    words += [*(f"-DBUILD_opencv_{name}=OFF" for name in left_out), *options]
    prepare = source.prepare
    release = release_of(source)
    if release is not None and release >= Version(known.apart_since):
        taken = " ".join(f".apart/modules/{name}" for name in (known.core, *(known.modules if whole else ())))
        clone = f"git clone --quiet --depth 1 --branch {source.ref} {known.apart} .apart"
        prepare = " && ".join(filter(None, (prepare, clone, f"mv {taken} modules/", "rm -rf .apart")))
    return replace(source, cmake_options=shlex.join(words), prepare=prepare)


def _gpus(evidence: Evidence, cuda: str) -> tuple[str, ...]:
    """Return the options for the GPUs that are usual for a CUDA, and for those that the code is compiled for."""
    known = [(Version(version), names) for version, names in architectures() if Version(version) <= Version(cuda)]
    usual = max(known)[1].removesuffix("+PTX").split(";") if known else []
    own = [f"{match[1]}.{match[2]}" for limit in gpu_limits(evidence) if (match := _GPU.fullmatch(limit.what))]
    all_ = sorted({*usual, *own}, key=Version)
    newest = (f"-DCUDA_ARCH_PTX={usual[-1]}",) if usual else ()
    return (f"-DCUDA_ARCH_BIN={','.join(all_)}", *newest) if all_ else ()


def compiled_without(libraries: Iterable[Source], evidence: Evidence, names: Collection[str]) -> Warning_ | None:
    """Return a warning where the code needs OpenCV's part for CUDA and nothing compiles it with that.

    ``names``: of all that is built from sources, in one spelling: an OpenCV of roslab.yaml's is the author's matter.
    """
    sign = needed(evidence)
    built = [source for source in libraries if plain(source.name) == LIBRARY]
    own = LIBRARY in names and not built
    if sign is None or own or any(_ON.search(source.cmake_options) for source in built):
        return None
    message = (
        f"the code needs OpenCV compiled with CUDA ({sign.what}), and this image's is not: the program stops there"
    )
    return warn(f"{message}; build OpenCV so under `source` in roslab.yaml, with -DWITH_CUDA=ON in cmake_options", sign)
