"""Which Python, by which manager, with which packages."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from roslab.config.model import Config, Kind
from roslab.decide.cuda.version import DEFAULT as CUDA
from roslab.decide.cuda.version import decide_cuda
from roslab.decide.decision import Python, Reason, Warning_
from roslab.decide.python.base import cuda_ubuntu
from roslab.decide.python.bounds import decide_bounds
from roslab.decide.python.framework_pins import framework_pins, one_build
from roslab.decide.python.packages import Chosen, choose, with_guess, with_includes
from roslab.decide.python.pins import conda_pins, name_of
from roslab.decide.python.pip_lists import pip_lists
from roslab.decide.python.refused import refused, repair, right
from roslab.decide.python.version import python_version
from roslab.decide.reasons import because
from roslab.decide.ros.workspace import packages_of, ros_versions, types
from roslab.decide.system.cmake_version import from_pip
from roslab.evidence.facts import Dependency, Evidence, PythonProject
from roslab.knowledge.distros import distro
from roslab.knowledge.frameworks import build_needs, canonical, imports, kept_for_build_types, version
from roslab.knowledge.tools import SYSTEM_PYTHON

DEFAULT = "3.10"
"""Where nothing is said: Ubuntu 22.04's own, for which most of today's and yesterday's wheels exist."""
_WHY = {"import": "imported, declared nowhere", "cmake": "the build asks for a newer one than the base has"}
_LOCAL = re.compile(r"^(?:torch|torchvision|torchaudio)\s*={2,3}\s*([\d.]+)\+(cu\d+|cpu|rocm[\d.]+)")


def decide_python(
    evidence: Evidence, config: Config, kind: Kind, ubuntu: str | None, ros_distro: str | None
) -> tuple[Python, tuple[Reason, ...], tuple[Warning_, ...]]:
    """Return the Python part of the image; ``ubuntu`` is ``None`` where the base is still to be chosen."""
    chosen = choose(evidence, config, kind)
    if newer := from_pip(evidence, kind, ubuntu):
        chosen = with_guess(chosen, newer)
    wanted, reasons = python_version(evidence, config)
    warnings: list[Warning_] = []
    plain = kind == "cpp" or (
        kind == "cuda" and not (chosen.files or chosen.projects or chosen.guessed or chosen.conda)
    )
    plain = plain and not (config.base.python or config.pip or config.pip3 or evidence.programs)
    if kind in {"ros1", "ros2"} or plain:
        manager, number = "system", _of_ros(ros_distro, wanted)
        ours = number or SYSTEM_PYTHON.get(ubuntu or "")
        if wanted and ours and wanted != ours and reasons[0].decisive and reasons[0].weight >= 50 and ros_distro:
            warnings.append(
                Warning_(
                    message=f"{reasons[0].reason}, but the Python of ROS {ros_distro} is {ours}: packages go there",
                    file=reasons[0].file,
                    line=reasons[0].line,
                )
            )
    else:
        number = wanted or _default(evidence, config, kind)
        if wanted is None:
            why = "nothing is said: the Python of the base"
            reasons = (Reason(question="python", answer=number, reason=why, weight=1), *reasons)
        manager = _manager(evidence, config, kind, ubuntu, number, chosen)
    lists = pip_lists(config, ubuntu, number)
    own = {canonical(project.name) for project in chosen.projects if project.name}
    repaired = repair(evidence, chosen.files, chosen.projects, own)
    declared, extra = [*lists.lines, *repaired.lines], repaired.files
    if chosen.conda and manager != "conda":
        declared += [d.name for e in evidence.conda if e.file == chosen.conda for d in e.dependencies if not d.role]
    warnings += [*repaired.warnings, *lists.warnings]
    kept = tuple(_kept(evidence, [*declared, *(d.name for d in (*chosen.guessed, *_from_files(evidence, chosen)))]))
    declared += [reason.answer for reason in kept]
    installed = [*declared, *(d.name for d in chosen.guessed)]
    everything = [*installed, *(d.name for d in _from_files(evidence, chosen))]
    # A distribution's own packages are as old as it is: only what pip chooses freely needs a bound
    bounds, bound_reasons = decide_bounds(evidence.bounds if manager != "system" else (), everything)
    cuda = decide_cuda(evidence, config).cuda
    if manager != "system":
        exact, exact_reasons = framework_pins(evidence, everything, cuda)
        bounds, bound_reasons = (*bounds, *exact), (*bound_reasons, *exact_reasons)
        installed += exact
    python = Python(
        version=number,
        bounds=bounds,
        manager=manager,  # type: ignore[arg-type]
        pip=tuple(dict.fromkeys(declared)),
        pip_guessed=tuple(dict.fromkeys(one_build(right(d.name for d in chosen.guessed), cuda))),
        requirements=tuple(file.file for file in chosen.files if file.file not in extra),
        projects=tuple(project.folder or "." for project in chosen.projects),
        alone=repaired.alone,
        conda_file=chosen.conda if manager == "conda" else None,
        first=_first(everything, chosen.projects),
        options=tuple(dict.fromkeys((*_indexes(installed), *_file_options(evidence, chosen, extra), *chosen.options))),
        pip_options=lists.options,
        python2=lists.python2,
        python2_options=lists.python2_options,
    )
    return python, (*reasons, *_package_reasons(chosen), *kept, *bound_reasons), tuple(warnings)


def _of_ros(ros_distro: str | None, wanted: str | None) -> str | None:
    """Return Python 2 where the distribution's nodes run on it and the author says so, else ``None``: Python 3."""
    known = distro(ros_distro) if ros_distro else None
    return known.python if known and wanted == known.python and wanted.startswith("2") else None


def specifiers(evidence: Evidence, python: Python) -> tuple[str, ...]:
    """Return every requirement line that the image installs: its own, those of the files, the projects and conda.

    conda's own packages stand by their names on the index, a bare ``git+URL`` by its repository's: this is a report.
    """
    lines = [*python.pip, *python.python2]
    by_path = {file.file: file for file in evidence.requirements}
    chosen = [by_path[path] for path in python.requirements if path in by_path]
    lines += [d.name for file in with_includes(evidence, chosen) for d in file.dependencies]
    for project in evidence.python:
        if (project.folder or ".") in python.projects:
            lines += [d.name for d in project.dependencies if not d.role.startswith(("extra", "test"))]
    for environment in evidence.conda:
        if environment.file == python.conda_file:
            lines += [d.name for d in environment.dependencies if d.role not in {"file", "option"}]
            lines += [pin.line for pin in conda_pins(environment)]
            named = [d.name.removeprefix("./") for d in environment.dependencies if d.role == "file"]
            folder = environment.file.rpartition("/")[0]
            lines += [
                d.name
                for file in with_includes(
                    evidence,
                    [f for f in evidence.requirements if f.file in {f"{folder}/{n}".strip("/") for n in named}],
                )
                for d in file.dependencies
            ]
    return tuple(dict.fromkeys(_readable(line) for line in (*lines, *python.pip_guessed) if not refused(line)))


def _readable(line: str) -> str:
    return f"{name_of(line)} @ {line}" if line.startswith("git+") and name_of(line) else line


def _default(evidence: Evidence, config: Config, kind: Kind) -> str:
    """Return the Python of the base: of the CUDA image's Ubuntu, of the one asked for, else the default."""
    ubuntu = config.base.ubuntu
    if kind == "cuda":
        ubuntu = cuda_ubuntu(decide_cuda(evidence, config).cuda or CUDA, ubuntu, DEFAULT)
    return SYSTEM_PYTHON.get(ubuntu or "", DEFAULT)


def _manager(  # noqa: PLR0917
    evidence: Evidence, config: Config, kind: Kind, ubuntu: str | None, number: str, chosen: Chosen
) -> str:
    """Return conda where an environment file says so or no base has that Python, else a virtual environment."""
    if chosen.conda or number.startswith("2"):
        return "conda"
    if kind == "cuda" and not config.base.image:
        cuda = decide_cuda(evidence, config).cuda or CUDA
        return "venv" if SYSTEM_PYTHON.get(cuda_ubuntu(cuda, config.base.ubuntu, number)) == number else "conda"
    if ubuntu or config.base.ubuntu:
        return "venv" if SYSTEM_PYTHON.get(config.base.ubuntu or ubuntu or "") == number else "conda"
    return "venv"


def _kept(evidence: Evidence, lines: Sequence[str]) -> Iterator[Reason]:
    """Yield what the build of the packages needs in a version that pip might replace, where pip installs anything."""
    named = {name_of(line) for line in lines}
    for manifest in packages_of(evidence).built if lines else ():
        for build_type in types(manifest, 2) if 2 in ros_versions(manifest) else ():
            for line, why in kept_for_build_types().get(build_type, ()):
                if name_of(line) not in named:
                    named.add(name_of(line))
                    yield because("dependencies", line, f"{build_type}: {why}", manifest, weight=40)


def _from_files(evidence: Evidence, chosen: Chosen) -> list[Dependency]:
    found = [d for file in with_includes(evidence, chosen.files) for d in file.dependencies]
    found += [d for project in chosen.projects for d in project.dependencies if d.role in {"", "source"}]
    return found + [d for e in evidence.conda if e.file == chosen.conda for d in e.dependencies]


def _first(lines: list[str], projects: Sequence[PythonProject]) -> tuple[str, ...]:
    """Return what must be there before the rest is built, with the pins that the rest asks for.

    Where there is any, the projects are built in the image's own environment: theirs must be in it as well.
    """
    by_name = {name_of(line): line for line in reversed(lines) if name_of(line)}
    extensions = {extension for project in projects for extension in project.extensions}
    needs: list[str] = []
    for line in lines:
        needs += build_needs().get(name_of(line), ())
    if "cuda" in extensions or ("c" in extensions and "torch" in by_name):
        needs += ["numpy", "torch"]
    elif "cython" in extensions or "c" in extensions:
        needs += ["numpy", "Cython"]
    for project in projects:
        needs += _for_setup(project)
    if needs:
        needs += [line for project in projects for line in project.build_requires]
    return tuple({name_of(need): by_name.get(name_of(need), need) for need in needs}.values())


def _for_setup(project: PythonProject) -> Iterator[str]:
    """Yield what a setup.py imports and an isolated build would not have."""
    isolated = {name_of(line) for line in project.build_requires}
    for module in project.setup_imports:
        if module == ".":  # and with it all that its own package imports
            yield "setuptools"
            yield from (d.name for d in project.dependencies if not d.role)
        elif (package := imports().get(module, (None, None))[0]) and name_of(package) not in isolated:
            yield package


def _indexes(lines: list[str]) -> list[str]:
    """Return where the wheels of a torch with a local version (``+cu113``) are served."""
    options = []
    for line in lines:
        if match := _LOCAL.match(line):
            old = version(match[1]) < (1, 11) and line.startswith("torch=")
            page = f"https://download.pytorch.org/whl/{match[2]}"
            options.append(f"--find-links {page}/torch_stable.html" if old else f"--extra-index-url {page}")
    return options


def _file_options(evidence: Evidence, chosen: Chosen, broken: frozenset[str]) -> list[str]:
    return [o for file in with_includes(evidence, [f for f in chosen.files if f.file in broken]) for o in file.options]


def _package_reasons(chosen: Chosen) -> tuple[Reason, ...]:
    reasons = [
        Reason(
            question="dependencies",
            answer=file.file,
            reason="requirements of the project",
            file=file.file,
            line=1,
            weight=40,
        )
        for file in chosen.files
    ]
    reasons += [
        Reason(
            question="dependencies",
            answer=project.folder or ".",
            reason="installable project",
            file=project.file,
            line=project.line,
            weight=40,
        )
        for project in chosen.projects
    ]
    reasons += [
        Reason(
            question="dependencies",
            answer=dependency.name,
            reason=_WHY.get(dependency.role, "named in an install line"),
            file=dependency.file,
            line=dependency.line,
            weight=10,
        )
        for dependency in chosen.guessed
    ]
    if chosen.conda:
        reasons.append(
            Reason(
                question="dependencies",
                answer=chosen.conda,
                reason="the project's conda environment",
                file=chosen.conda,
                line=1,
                weight=45,
            )
        )
    return tuple(reasons)
