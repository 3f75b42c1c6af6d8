"""What must be installed before the rest can be built: numpy, torch, Cython, what a setup.py imports."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from roslab.decide.python.bounds import excluded
from roslab.decide.python.packages import Chosen
from roslab.decide.system.cmake_version import BRINGS_CMAKE, NEW
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.compiled import prebuilt
from roslab.knowledge.frameworks import backend_needs, build_needs, framework_on_cuda, imports
from roslab.knowledge.guesses import tooling
from roslab.values.interpreter import Interpreter
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def first(
    asked: Sequence[Requirement], projects: Sequence[PythonProject], *, cmake: bool = False
) -> tuple[Requirement, ...]:
    """Return what must be installed before the rest is built, with the pins that the rest asks for.

    ``cmake``: the base may have no CMake, which a setup.py then calls in vain.

    If there is anything, the projects are built in the image's own environment, which then needs their build
    requirements too.
    """
    limited_first = sorted((each for each in asked if each.name), key=lambda each: not each.limited)
    by_name = {each.key: each for each in reversed(limited_first)}
    extensions = {extension for project in projects for extension in project.extensions if not _isolated(project)}
    needs = [stated(name) for each in asked for name in build_needs().get(each.key, ())]
    if "cuda" in extensions or ("c" in extensions and "torch" in by_name):
        needs += [stated("numpy"), stated("torch")]
    elif "cython" in extensions or "c" in extensions:
        needs += [stated("numpy"), stated("Cython")]
    needs += [need for project in projects for need in _for_setup(project)]
    if any(each.package and each.key not in {*prebuilt(), "cmake"} for each in asked):  # a list tells no order
        needs = [*(each for each in asked if each.key == "cmake" and each.origin == "manifest"), *needs]
    if cmake and any(map(_calls_cmake, projects)):
        needs.append(stated(f"cmake<{NEW.major}"))
    if needs:
        asking = [line for project in projects for line in project.build_requires]
        known = build_needs() | backend_needs()
        while_building = [name for line in asking for name in known.get(line.key, ())]
        needs += [*asking, *map(stated, while_building)]
    return tuple({need.key: _as_asked(need, by_name.get(need.key)) for need in needs}.values())


def first_and_guesses(
    asked: Iterable[Requirement], chosen: Chosen, interpreter: Interpreter, *, cmake: bool
) -> tuple[tuple[Requirement, ...], tuple[Requirement, ...]]:
    """Return what must be installed before what is required, and the guesses, ahead of them what these must find.

    What only a guess needs is as optional as the guess, and stops no build; a guess may tell the version of the first.
    """
    required = tuple(filter(interpreter.may, asked))
    guessed = tuple(filter(interpreter.may, chosen.guessed))
    needed = {each.key for each in first(required, chosen.projects, cmake=cmake)}
    whole = first((*guessed, *required), chosen.projects, cmake=cmake) if needed else ()
    ahead = tuple(each for each in whole if each.key in needed)
    there = {each.key for each in (*required, *ahead)}
    optional = {each.key: each for each in first(guessed, ()) if each.key not in there}
    return ahead, (*optional.values(), *(each for each in guessed if each.key not in optional))


def isolated(projects: Sequence[PythonProject], compiled_first: Sequence[Requirement]) -> tuple[str, ...]:
    """Return the folders of the projects that pip can build in isolation all the same, though some package cannot be.

    Their backend compiles nothing and nothing else builds with it, so that what must be there first is for others; or
    their pyproject.toml names all that their extensions are built with, and that is for none of what is installed.
    """
    return tuple(p.folder or "." for p in projects if compiled_first and (_compiles_nothing(p) or _by_itself(p)))


def _compiles_nothing(project: PythonProject) -> bool:
    keys = {each.key for each in project.build_requires}
    plain = not project.extensions and not project.setup_imports
    return plain and bool(keys) and keys.issubset(tooling("backends"))


def _by_itself(project: PythonProject) -> bool:
    """Tell whether it compiles with what its pyproject.toml names, and with nothing that must be what is installed."""
    keys = {each.key for each in project.build_requires}
    installed = {"numpy", *(key for key in keys if framework_on_cuda(key))}
    return (
        {"c", "cython", "cmake"}.issuperset(project.extensions)
        and _isolated(project)
        and keys.isdisjoint(installed)
        and "." not in project.setup_imports
        and not tuple(_for_setup(project))
    )


def _as_asked(need: Requirement, author: Requirement | None) -> Requirement:
    """Return the author's own line for what is needed, unless it is free and would bring what is too new."""
    if author is None or (need.limited and not author.limited and not excluded(need, (author,))):
        return need
    return author


def _isolated(project: PythonProject) -> bool:
    """Tell whether its pyproject.toml names what its extensions are built with: pip then brings exactly that.

    An extension of torch is built in the image's own environment all the same: it must fit the torch that is there.
    """
    needs = {each.key for each in project.build_requires} - {"setuptools", "wheel", "setuptools-scm"}
    named = any(each.file.endswith("pyproject.toml") for each in project.build_requires)
    return bool(needs) and named and "cuda" not in project.extensions


def _calls_cmake(project: PythonProject) -> bool:
    """Tell whether its setup.py calls a CMake that nothing which it is built with brings."""
    return "cmake" in project.extensions and BRINGS_CMAKE.isdisjoint(each.key for each in project.build_requires)


def _for_setup(project: PythonProject) -> Iterator[Requirement]:
    """Yield what a setup.py imports and an isolated build would not have."""
    isolated = {each.key for each in project.build_requires}
    for module in project.setup_imports:
        if module == ".":  # and so all that its own package imports
            yield stated("setuptools")
            yield from (each for each in project.requirements if not each.role)
        elif package := imports().get(module, (None, None))[0]:
            yield from _unless(isolated, stated(package))


def _unless(isolated: Iterable[str], asked: Requirement) -> Iterator[Requirement]:
    if asked.key not in isolated:
        yield asked
