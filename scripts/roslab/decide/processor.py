"""What the code asks of the processor: options and headers of x86, without which or not at all it compiles for ARM."""

from __future__ import annotations

from collections.abc import Collection

from roslab.config.model import BuildTool, Kind
from roslab.decide import downloads
from roslab.decide.decision import Warning_
from roslab.decide.python.image_python import Python
from roslab.decide.ros.workspace import Packages
from roslab.decide.system import own_packages
from roslab.decide.system.unreached import unreached
from roslab.evidence.facts import Evidence
from roslab.evidence.native.cpu import told
from roslab.evidence.x86_only import X86Only
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class OnX86:
    """What is compiled for x86 alone."""

    needed: X86Only | None = None
    """The first that rules out every other processor."""
    left_out: tuple[X86Only, ...] = ()
    """Options that only tune: the build for another processor goes without them."""


def decide_processor(
    evidence: Evidence, kind: Kind, build_tool: BuildTool, packages: Packages, python: Python, *, as_it_is: bool
) -> OnX86:
    """Return what only x86 has of what the image compiles; ``as_it_is``: nothing may be changed in the tree."""
    folders = {manifest.file.rpartition("/")[0] for manifest in packages.built} if kind in {"ros1", "ros2"} else set()
    by_cmake = bool(folders) or build_tool == "cmake"
    folders |= {""} if build_tool == "cmake" or (evidence.makefiles and kind in {"cpp", "cuda"}) else set()
    made = {makefile.file for makefile in evidence.makefiles}
    parts = {folder for makefile in evidence.makefiles for folder in makefile.parts}
    installed = [p for p in evidence.python if p.extensions and (p.folder or ".") in python.projects]
    by_pip = {project.folder for project in installed}
    # A program of Python opens a library where it lies: there is no build that it would be part of
    ours = {"setup.py": by_pip, "opened by Python": folders | by_pip if kind in {"ros1", "ros2"} else {""}}
    anew = {path for mention in evidence.mentions if mention.topic == "make" for path in mention.files[1:]}
    compiled = [
        each
        for each in evidence.x86_only
        if not (each.source == "started" and each.what in anew and kind in {"ros1", "ros2"})
        and (
            each.file in made or each.file.rpartition("/")[0] in parts
            if each.source == "make"
            else _below(each.file, ours.get(each.source, folders | by_pip))
        )
    ]
    by_file = own_packages.for_x86_alone(evidence) if by_cmake else None
    if brought := by_file or (downloads.for_x86_alone(evidence) if folders | by_pip else None):
        return OnX86(needed=brought)
    if not compiled:
        return OnX86()
    needed = [each for each in compiled if each.source != "cmake" or as_it_is or not by_cmake]
    return OnX86(needed=needed[0]) if needed else OnX86(left_out=tuple(compiled))


def compiles_for_here(evidence: Evidence) -> bool:
    """Tell whether a build file has the compiler make programs for the processor of the machine that builds."""
    return told(evidence.problems)


def stops_at_warnings(evidence: Evidence) -> bool:
    """Tell whether a build file has warnings of the compiler count as errors."""
    return any(mention.topic == "strict" for mention in evidence.mentions)


def problems(
    evidence: Evidence, dockerfile: str | None, build_tool: BuildTool, projects: Collection[str]
) -> tuple[Warning_, ...]:
    """Return what the readers found wrong as warnings, and of options for one machine what the build does about it.

    Of these only the first that is compiled, else the first, is told. ``dockerfile``: the author's own, if that is
    built; ``projects``: the folders that pip installs.
    """
    own = f"; {dockerfile}, which is the author's, compiles with it as it stands: take it out here"
    does = "; a generated Dockerfile compiles for usual PCs since 2013, or for ARM of 64 bits, in its place"
    other = "; the image does not compile it"
    found = []
    native = [each for each in evidence.problems if told([each])]
    compiled = (each for each in native if _compiles(each[1] or "", evidence, build_tool, projects))
    first = next(compiled, None)
    shown = (native[0] if dockerfile else first or native[0]) if native else None
    for message, file, line in dict.fromkeys(evidence.problems):
        what = ""
        if told([(message, file, line)]):
            if (message, file, line) != shown:
                continue
            what = own if dockerfile else does if first else other
        found.append(Warning_(message=f"{message}{what}", file=file, line=line))
    return tuple(found)


def _compiles(file: str, evidence: Evidence, build_tool: BuildTool, projects: Collection[str]) -> bool:
    """Tell whether the image compiles what a Makefile or a file of CMake is for."""
    folder = file.rpartition("/")[0]
    if not file.endswith((".txt", ".cmake")):
        called = {each for made in evidence.makefiles for each in (made.folder, *made.parts)}
        return folder in called or any(f"{folder}/".startswith(f"{each}/".lstrip("/")) for each in called)
    by_pip = any(each.extensions and (each.folder or ".") in projects for each in evidence.python)
    by_script = build_tool in {"pip", "conda"} and any(m.topic == "build_script" and m.files for m in evidence.mentions)
    by_tool = build_tool not in {"none", "pip", "conda"} and file not in unreached(evidence, by_page=False)
    return by_tool or by_pip or by_script


def _below(file: str, folders: set[str]) -> bool:
    return any(not folder or file.startswith(f"{folder}/") for folder in folders)
