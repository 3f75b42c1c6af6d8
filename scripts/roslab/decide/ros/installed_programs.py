"""Programs of ``ros2 run`` on pages that the named package of Python does not install: another one may be meant.

An author moves a node to another package, or renames a program in setup.py, and forgets the page.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from roslab.decide.candidate import Candidate
from roslab.decide.programs import one_letter_off
from roslab.decide.ros.workspace import packages_of, types
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

_RUN = ("ros2", "run")
_Programs = Mapping[str, Mapping[str, str]]
"""The programs of each package, with the last name of the module that each starts, ``""`` where it is not known."""


def with_installed(calls: Iterable[Candidate], evidence: Evidence) -> Iterator[Candidate]:
    """Yield the calls, those of a program that its package lacks with the one that is meant, weaker where none is."""
    programs = _programs(evidence)
    files = {each.file.rpartition("/")[2].removesuffix(".py") for each in evidence.programs}
    for call in calls:
        package, program = call.argv[2:4] if call.argv[:2] == _RUN and len(call.argv) > 3 else ("", "")
        if program in programs.get(package, {program: ""}):
            yield call
        elif found := _meant(package, program, programs):
            yield replace(call, argv=(*_RUN, *found, *call.argv[4:]))
        else:
            known = program.startswith("-") or program.removesuffix(".py") in files
            yield call if known else replace(call, strong=False)


def _meant(package: str, program: str, programs: _Programs) -> tuple[str, str] | None:
    """Return package and program: of the only other one that has it, that of a module, or one with a letter more."""
    own, stem = programs[package], program.removesuffix(".py")
    others = [name for name, found in programs.items() if program in found]
    if len(others) == 1:
        return others[0], program
    of_module = [name for name, module in own.items() if stem in {module, name}]
    found = of_module[0] if len(of_module) == 1 else one_letter_off(program, own)
    return (package, found) if found else None


def _programs(evidence: Evidence) -> _Programs:
    """Return those of the packages that Python builds alone, and whose setup.py or setup.cfg says which they are."""
    folders = {m.file.rpartition("/")[0]: m.name for m in packages_of(evidence).built if "ament_python" in types(m, 2)}
    by_cmake = {project.file.rpartition("/")[0] for project in evidence.cmake}
    found: dict[str, dict[str, str]] = {}
    for project in evidence.python:
        package = folders.get(project.folder)
        if package and project.folder not in by_cmake and project.scripts and not project.more_programs:
            names = [name for name, _ in project.scripts]
            modules = [each.rpartition(".")[2] for each in project.modules]
            modules = modules if len(modules) == len(names) else [""] * len(names)
            programs = found.setdefault(package, {})
            programs |= dict(zip(names, modules, strict=True))
            programs |= {file.rpartition("/")[2]: "" for file in project.script_files}
    return found
